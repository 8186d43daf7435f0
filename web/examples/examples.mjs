// What the buttons do.
const planet = document.getElementById('changed');
const place = planet.parentElement;
const told = document.getElementById('told');

await customElements.whenDefined('terrella-planet');
planet.on('change', () => { told.textContent = `The sea stands ${(1000 * planet.get('water.level')).toFixed(0)} mm over a planet of one metre.`; });

document.getElementById('flood').addEventListener('click', async () => {
  await planet.ready;
  planet.set('water.level', planet.get('water.level') + 0.01);
});

const away = document.getElementById('away');
away.addEventListener('click', () => {
  if (planet.isConnected) planet.remove();
  else place.prepend(planet);
  away.textContent = planet.isConnected ? 'Take the planet away' : 'Put the planet back';
});
