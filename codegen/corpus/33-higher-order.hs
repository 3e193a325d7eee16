twice :: (a -> a) -> a -> a
twice f = f . f

compose :: [a -> a] -> a -> a
compose = foldr (.) id

applyAll fs x = map ($ x) fs

main :: IO ()
main = simulate . Say . show $ twice (+ 3) 4
