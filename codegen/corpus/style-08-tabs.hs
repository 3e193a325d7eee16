-- Tabs between and before.
module Main where

data Way	= Left'
		| Right'
		deriving (Show,	Eq)

turn	:: Way -> Velocity
turn	Left'	= Velocity 0 1
turn	Right'	=
	Velocity	0	(-1)

big :: Int -> String
big n
	| n > 3		= "big"
	| otherwise	= small
	where
	small	= "small"

plan :: Task ()
plan = do
	say "one"
	let	x = 1
		y = 2
	when (x > (y :: Int)) $ do
		say "two"
        wait 1
	say "three"

main = simulate plan
