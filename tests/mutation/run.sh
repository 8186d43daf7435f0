#!/bin/sh
# Plants mistakes in a copy of the shader library, one at a time, and sees which tests notice.
#   tests/mutation/run.sh             all mistakes of mistakes.txt; ends with 1 if a test missed one
#   tests/mutation/run.sh PATTERN     only those whose line matches (grep)
#   tests/mutation/run.sh --markdown  the table of what has been run, for docs/numerics.md
# STAGES="laws" tests/mutation/run.sh: of the folders of tests only these.
set -eu

root=$(cd "$(dirname "$0")/../.." && pwd)
mistakes=$root/tests/mutation/mistakes.txt
work=$root/build/mutation
copy=$work/source
build=$work/build
results=$work/results  # a line for each mistake: what caught it, a tab, the mistake
log=$work/log
stages=${STAGES:-laws f32 probe gpu reference images}  # in this order, until one notices

fail() {
  echo "$*" >&2
  exit 1
}

# The lines of mistakes.txt that hold one.
listed() {
  grep -v -e '^#' -e '^$' "$mistakes"
}

# The parts of a line `file: old text => new text`.
file_of() { printf '%s' "${1%%: *}"; }
old_of() { rest=${1#*: } && printf '%s' "${rest%% => *}"; }
new_of() { printf '%s' "${1##* => }"; }

# Brings the copy up to what the tree holds now. Files that are the same keep their time, so that nothing is built anew.
update_copy() {
  mkdir -p "$copy"
  (cd "$root" && git ls-files -co --exclude-standard) | sort | while IFS= read -r file; do
    [ -f "$root/$file" ] && printf '%s\n' "$file"
  done > "$work/files"
  (cd "$copy" && find . -type f | sed 's,^\./,,') | sort | comm -13 "$work/files" - | while IFS= read -r file; do
    rm "$copy/$file"
  done
  while IFS= read -r file; do
    cmp -s "$root/$file" "$copy/$file" && continue
    mkdir -p "$copy/$(dirname "$file")"
    cp "$root/$file" "$copy/$file"
  done < "$work/files"
}

# Few optimizations: it is built as often as it is run. No warnings: a mistake may leave an argument unused.
configure() {
  cmake -S "$copy" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1 -DCMAKE_CXX_FLAGS=-w \
    -DCMAKE_PROJECT_terrella_INCLUDE="$copy/tests/mutation/subjects.cmake" > "$log" 2>&1 ||
    fail "Configuring the copy failed; see $log"
}

# Puts the new text in the place of the old one, which must be there exactly once.
plant() {
  OLD=$2 NEW=$3 perl -e '
    my ($file) = @ARGV;
    my ($old, $new) = ($ENV{OLD}, $ENV{NEW});
    open(my $in, "<", $file) or exit 2;
    local $/;
    my $text = <$in>;
    close $in;
    my $at = index($text, $old);
    exit 3 if $at < 0 || index($text, $old, $at + 1) >= 0;
    substr($text, $at, length $old) = $new;
    open(my $out, ">", $file) or exit 2;
    print $out $text;
    close $out;' "$1"
}

build_program() {
  nice -n 5 cmake --build "$build" --target "$1" -j "${JOBS:-2}" > "$log" 2>&1
}

# A mistake may also make a loop endless.
run_program() {
  (cd "$build" && perl -e 'alarm shift; exec @ARGV' 1200 "$1" --gtest_fail_fast) > "$work/said" 2>&1
}

# A stage is the program tests/<stage>_tests of a folder, or that of the laws of one subject (subjects.cmake).
build_stage() {
  case $1 in *_test) build_program "$1" ;; *) build_program "$1_tests" ;; esac
}

run_stage() {
  case $1 in *_test) run_program "./$1" ;; *) run_program "tests/$1_tests" ;; esac
}

# The stages for a file, its own laws first.
stages_for() {
  subject=${1%.glsl}
  [ ! -e "$root/tests/laws/${subject}_test.cpp" ] || printf '%s ' "${subject}_test"
  echo "$stages"
}

# Without a mistake a stage must pass, or it could not tell one. Seen to only where the stages before have missed one.
passing=""
expect_passing() {
  case " $passing " in *" $1 "*) return ;; esac
  build_stage "$1" || fail "The $1 tests do not build as they are; see $log"
  run_stage "$1" || fail "The $1 tests do not pass as they are; see $work/said"
  passing="$passing $1"
}

# Sets caught to what notices the mistake of a line: a folder and a test, or "nothing".
catcher() {
  file=shaders/lib/$(file_of "$1")
  old=$(old_of "$1")
  new=$(new_of "$1")
  for stage in $(stages_for "$(file_of "$1")"); do
    cmp -s "$root/$file" "$copy/$file" || cp "$root/$file" "$copy/$file"
    expect_passing "$stage"
    plant "$copy/$file" "$old" "$new" || fail "$file does not hold exactly once: $old"
    build_stage "$stage" || fail "It does not build with: $1; see $log"
    if ! run_stage "$stage"; then
      case $stage in *_test) stage=laws ;; esac
      caught="$stage $(sed -n 's/^\[  FAILED  \] \([^ ,]*\).*/\1/p' "$work/said" | sed -n 1p)"
      break
    fi
    caught=nothing
  done
  cp "$root/$file" "$copy/$file"
}

remember() {
  touch "$results"
  MISTAKE=$2 perl -ne 'chomp; my ($by, $mistake) = split /\t/, $_, 2; print "$_\n" if $mistake ne $ENV{MISTAKE}' \
    "$results" > "$results.new"
  printf '%s\t%s\n' "$1" "$2" >> "$results.new"
  mv "$results.new" "$results"
}

remembered() {
  [ -e "$results" ] || return 0
  MISTAKE=$1 perl -ne 'chomp; my ($by, $mistake) = split /\t/, $_, 2; print $by if $mistake eq $ENV{MISTAKE}' "$results"
}

# For each file how many mistakes there are and what has noticed them: the folder and, of their names, the first parts.
markdown() {
  listed | while IFS= read -r line; do
    by=$(remembered "$line")
    printf '%s\t%s\n' "$(file_of "$line")" "${by:-not run}"
  done | perl -ne '
    chomp;
    my ($file, $by) = split /\t/;
    my ($stage, $test) = split / /, $by, 2;
    $test =~ s/\..*//;
    push @files, $file unless $mistakes{$file}++;
    $by{$file}{$stage}{$test} = 1;
    $all{$stage}++;
    END {
      print "| file | mistakes | noticed by |\n| --- | --- | --- |\n";
      for my $file (@files) {
        my @by = map { "$_: " . join(", ", sort keys %{$by{$file}{$_}}) } sort keys %{$by{$file}};
        print "| `$file` | $mistakes{$file} | ", join("; ", @by), " |\n";
      }
      print "| all | $.", " | ", join(", ", map { "$_: $all{$_}" } sort { $all{$b} <=> $all{$a} } keys %all), " |\n";
    }'
}

if [ "${1:-}" = --markdown ]; then
  markdown
  exit
fi

mkdir -p "$work"
[ $# -gt 0 ] || rm -f "$results"
update_copy
configure
listed > "$work/all"
if [ $# -gt 0 ]; then
  grep -e "$1" "$work/all" > "$work/chosen" || fail "No mistake matches $1."
else
  cp "$work/all" "$work/chosen"
fi
# An error of the list is told before anything is built.
while IFS= read -r line; do
  file=shaders/lib/$(file_of "$line")
  cp "$root/$file" "$work/tried" 2>> "$log" || fail "There is no $file."
  plant "$work/tried" "$(old_of "$line")" "$(new_of "$line")" || fail "$file does not hold exactly once: $(old_of "$line")"
done < "$work/chosen"

count=0
noticed=0
while IFS= read -r line; do
  catcher "$line" < /dev/null
  remember "$caught" "$line"
  count=$((count + 1))
  [ "$caught" = nothing ] || noticed=$((noticed + 1))
  printf '%-50s %s\n' "$caught" "$line"
done < "$work/chosen"
echo "$noticed of $count caught"
[ "$noticed" = "$count" ]
