// What everything that drives a browser needs.
export const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';

export const sleep = ms => new Promise(done => setTimeout(done, ms));

// Asks the page until it says yes. (Playwright's own waiting is forbidden by the page's security policy.)
export async function until(page, question, argument) {
  for (let i = 0; i < 600; ++i) {
    if (await page.evaluate(question, argument)) return;
    await sleep(100);
  }
  throw new Error('waited in vain for ' + question);
}
