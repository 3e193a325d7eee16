{- outer {- inner -} still outer -}
go :: Velocity
go = {- why not -} Velocity 0.1 {- {- deep -} -} 0

--- three dashes
-----------------
main :: IO ()
main = simulate go --> comment
  where
    (-->) = const
    comment = 1
