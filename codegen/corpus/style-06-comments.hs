{- | A header comment
   over lines, with {- one inside -} it.
-}
module Main {- here too -} (main) where -- and here

-- | Goes.
--
-- >>> go 1
go :: Double -- ^ how fast
   -> Velocity -- ^ what to do
go v {- speed -} = Velocity {- first -} v {- second -} 0 -- last

-- * A heading

-- $doc
-- Named chunk.

{-| Block haddock. -}
stop :: Velocity
stop = -- nothing moves
  Velocity 0 -- forward
    0 -- around

-- ---------------------------------------------------------------
--------------------------------------------------------------- --
-- |> is a comment, too

mode :: Int -> {- in the type -} String
mode n {- before the bar -}
  {- above -} | n > 0 {- condition -} = {- then -} "up" -- ok
  -- between two
  | otherwise -- else
  = "down"
  -- before where
  where {- nothing here yet -}

steps :: Task ()
steps = do -- begin
  -- first
  say "a" -- said

  {- second,
     long -}
  wait 1 {- unit: -} -- seconds
  -- last
  say "b"
  -- after the end

list :: [Int]
list =
  [ 1 -- one
  , 2 -- two
    -- three is left out
  , 4 {- four -}
  ] -- end

(-->) :: Int -> Int -> Int
a --> b = a + b -- `-->` is an operator
x |-- y = x - y

main = simulate stop -- the end
{- really
-}
