# cmake -DDIST=folder -DFILES=index.html,page.css,… -P worker.cmake
# Writes DIST/worker.js, whose version is a hash of the files that it keeps: when one of them changes, so does the worker,
# and that is how browsers learn that there is something new.
string(REPLACE "," ";" files "${FILES}")
set(hashes "")
foreach(file IN LISTS files)
  file(SHA256 ${DIST}/${file} hash)
  string(APPEND hashes "${file} ${hash}\n")
endforeach()
string(SHA256 VERSION "${hashes}")
string(SUBSTRING ${VERSION} 0 16 VERSION)
list(TRANSFORM files REPLACE "^index\\.html$" "./")  # the name by which it is visited
list(JOIN files "', '" FILES)
configure_file(${CMAKE_CURRENT_LIST_DIR}/worker.js.in ${DIST}/worker.js @ONLY)
