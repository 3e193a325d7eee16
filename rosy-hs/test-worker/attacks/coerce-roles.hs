import Data.Coerce

main = simulate (coerce (pure 'x' :: Task Char) :: Task Int)
