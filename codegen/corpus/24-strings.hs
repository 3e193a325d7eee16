words1 :: [String]
words1 = ["plain", "with \"quotes\"", "tab\there", "line\nbreak", "back\\slash", "", "caf\233", "\1234\&5", "\SOH\DEL", "gap \
         \goes on"]

letters :: [Char]
letters = ['a', '\'', '"', '\n', '\\', 'ü', '\t', '\x41']

main = simulate (Say (concat words1))
