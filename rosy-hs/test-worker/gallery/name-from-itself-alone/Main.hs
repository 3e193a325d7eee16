n :: Int
n = n + 1

count :: Bumper -> Say
count _ = Say (show n)

main = simulate count
