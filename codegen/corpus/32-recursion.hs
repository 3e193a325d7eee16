fac :: Integer -> Integer
fac 0 = 1
fac n = n * fac (n - 1)

fib :: Int -> Int
fib n
  | n < 2 = n
  | otherwise = fib (n - 1) + fib (n - 2)

len :: [a] -> Int
len [] = 0
len (_ : xs) = 1 + len xs

swap2 :: [a] -> [a]
swap2 (a : b : rest) = b : a : swap2 rest
swap2 xs = xs

exactly :: [Int] -> Bool
exactly [1, 2, x] = x == 3
exactly _ = False

main = simulate (Say (show (fac 5, fib 10, len "abc", swap2 [1, 2, 3])))
