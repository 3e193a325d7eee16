-- recursion, local functions, guards, let, where, typeclass-polymorphic helper, folds
fib :: Int -> Integer
fib n = go n 0 1
  where
    go 0 a _ = a
    go k a b = go (k - 1) b (a + b)

count :: () -> Memory Int -> (Memory Int, Maybe Say)
count () (Memory n) = (Memory (n + 1), out)
  where
    out | n > 0, even n, n < 11 = let f = fib n in Just (Say (show n ++ ":" ++ show f))
        | otherwise = Nothing

main = simulate count
