isEven, isOdd :: Int -> Bool
isEven 0 = True
isEven n = isOdd (n - 1)

isOdd 0 = False
isOdd n = isEven (n - 1)

main = simulate (Say (show (isEven 10)))
