{-# LANGUAGE NumericUnderscores, BinaryLiterals #-}
-- Numbers, characters and texts.
million :: Int
million = 1_000_000

mask :: Int
mask = 0b1010 + 0x_ff + 0XFF + 0o17 + 0O17

tiny, huge' :: Double
tiny = 1e-9 + 1.5e-3 + 1E+2 + 2.5E0
huge' = 6.022_140e23

negatives :: [Int]
negatives = [-1, - 2, negate (-3), (-4), 5 - 6, 5 -7, (subtract 8) 9, 10-11]

minus :: Int -> Int
minus (-1) = -1
minus n | n < -5 = -n
minus n = -n - 1

characters :: String
characters = ['a', '\'', '"', '\n', '\t', '\\', '\x41', '\o101', '\65', '\DEL', '\^A', 'é', '名', '🤖', ' ']

texts :: [String]
texts = ["", "plain", "with \"quotes\"", "tab\tline\nend\\", "uni\1234\&5", "\SOH\&", "\x41\&1",
  "gap \
  \over lines\
      \ and on", "{- none -}", "名前 🤖 é"]

dashes :: String
dashes = "-- no comment"

prime', prime'' :: Int
prime' = 1
prime'' = prime' + 1

main = simulate (once (Say (concat texts ++ characters)))
