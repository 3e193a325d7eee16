# shellcheck shell=bash
# Sourced by ./rosy: sentences in the language of the machine's locale, before anything is installed.
#
# In: an English template with values for its placeholders. Out: the sentence of `languages/<language>/sentences.json`, the same
# tables that the service reads (sim-service/rosy_sim/sentences/wording.py), or English for a language without a table. Bash alone reads the
# tables, which works because they hold one sentence a line; scripts/sentences.py checks both.

# The first variable that is set names the language. POSIX.1-2017, Base Definitions, section 8.2.
language_of_locale() {
  local locale="${ROSY_LOCALE:-${LC_ALL:-${LC_MESSAGES:-${LANG:-}}}}"
  locale=${locale%%[.@]*}
  case "$locale" in
    en_XA | en-XA) echo en-XA ;;
    C | POSIX | "") echo en ;;
    *) echo "${locale%%[_-]*}" ;;
  esac
}
ROSY_LANGUAGE=$(language_of_locale)

# sentence TEMPLATE [NAME VALUE]...: prints the sentence, with the values in place of {NAME}.
sentence() {
  local said
  said=$(translation "$1")
  shift
  while [ $# -gt 1 ]; do
    said=${said//"{$1}"/"$2"}
    shift 2
  done
  printf '%s\n' "$said"
}

# give_up TEMPLATE [NAME VALUE]...: the sentence, and the end of the command.
give_up() {
  printf 'rosy: %s\n' "$(sentence "$@")" >&2
  exit 1
}

# translation TEMPLATE: the template in the language of the locale.
translation() {
  local table="$ROSY_ROOT/languages/$ROSY_LANGUAGE/sentences.json" key=$1 line start
  if [ "$ROSY_LANGUAGE" = en-XA ]; then
    accented "$1"
  elif [ -f "$table" ]; then
    key=${key//\\/\\\\}
    start="    \"${key//\"/\\\"}\": \""
    while IFS= read -r line; do
      if [[ "$line" == "$start"* ]]; then
        line=${line#"$start"}
        line=${line%,}
        line=${line%\"}
        line=${line//\\\"/\"}
        printf '%s\n' "${line//\\\\/\\}"
        return
      fi
    done <"$table"
    printf '%s\n' "$1"
  else
    printf '%s\n' "$1"
  fi
}

# accented TEMPLATE: English with accents outside of the placeholders, for tests (`PSEUDO` in sim-service/rosy_sim/sentences/wording.py).
accented() {
  local rest=$1 said=
  while [[ "$rest" == *"{"*"}"* ]]; do
    said+=$(with_accents "${rest%%\{*}")
    rest=${rest#*\{}
    said+="{${rest%%\}*}}"
    rest=${rest#*\}}
  done
  printf '%s%s\n' "$said" "$(with_accents "$rest")"
}
with_accents() {
  local text=$1 pair
  for pair in aå bƀ cç dđ eé fƒ gĝ hĥ iî jĵ kķ lļ mɱ nñ oö pþ qǫ rŕ sš tţ uû vṽ wŵ xẋ yý zž \
    AÅ BƁ CÇ DĐ EÉ FƑ GĜ HĤ IÎ JĴ KĶ LĻ MṀ NÑ OÖ PÞ QǪ RŔ SŠ TŢ UÛ VṼ WŴ XẊ YÝ ZŽ; do
    text=${text//${pair:0:1}/${pair:1}}
  done
  printf '%s' "$text"
}

# help_page NAME: the file of the page in the language of the locale; nothing when there is no such page.
help_page() {
  local folder="$ROSY_ROOT/languages/$ROSY_LANGUAGE/help"
  [ -d "$folder" ] || folder="$ROSY_ROOT/languages/en/help"
  case "$1" in "" | */*) ;; *) [ ! -f "$folder/$1.txt" ] || printf '%s\n' "$folder/$1.txt" ;; esac
}

# rosy_version: the version of this Rosy; its only source is rosy.cabal.
rosy_version() { sed -n 's/^version: *//p' "$ROSY_ROOT/rosy.cabal"; }
