# cmake -DDIST=folder -DFILES=index.html,page.css,… -DFILES_OF_REAL_SIZE=… -P worker.cmake
# Writes DIST/worker.js, whose version is a hash of the files that it keeps: when one of them changes, so does the worker,
# and that is how browsers learn that there is something new.
string(REPLACE "," ";" files "${FILES}")
string(REPLACE "," ";" files_of_real_size "${FILES_OF_REAL_SIZE}")
set(hashes "")
foreach(file IN LISTS files files_of_real_size)
  file(SHA256 ${DIST}/${file} hash)
  string(APPEND hashes "${file} ${hash}\n")
endforeach()
string(SHA256 VERSION "${hashes}")
string(SUBSTRING ${VERSION} 0 16 VERSION)
list(TRANSFORM files REPLACE "^index\\.html$" "./")  # the name by which it is visited
list(JOIN files "', '" FILES)
list(JOIN files_of_real_size "', '" FILES_OF_REAL_SIZE)
configure_file(${CMAKE_CURRENT_LIST_DIR}/worker.js.in ${DIST}/worker.js @ONLY)
