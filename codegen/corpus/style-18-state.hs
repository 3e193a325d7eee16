{-|
Module      : Main
Description : A hand-made state monad
-}
module Main (main) where

import qualified Data.Map.Strict as Map
import Data.Map.Strict (Map)

type Name = String

newtype State s a = State { runState :: s -> (a, s) }

instance Functor (State s) where
  fmap f (State g) = State $ \s -> let (a, s') = g s in (f a, s')

instance Applicative (State s) where
  pure a = State $ \s -> (a, s)
  State f <*> State g = State $ \s ->
    let (h, s') = f s
        (a, s'') = g s'
     in (h a, s'')

instance Monad (State s) where
  return = pure
  m >>= k = State $ \s -> case runState m s of (a, s') -> runState (k a) s'

get' :: State s s
get' = State $ \s -> (s, s)

put' :: s -> State s ()
put' s = State $ const ((), s)

fresh :: State (Int, Map Name Int) Int
fresh = do
  (n, m) <- get'
  put' (n + 1, m)
  pure n

intern :: Name -> State (Int, Map Name Int) Int
intern name = do
  (_, m) <- get'
  case Map.lookup name m of
    Just i -> return i
    Nothing -> do
      i <- fresh
      (n, m') <- get'
      let m'' = Map.insert name i m'
      put' (n, m'')
      return i

ids :: [Name] -> [Int]
ids names = fst $ mapM intern names `runState` (0, Map.empty)

main = simulate . once . Say . show $ ids ["a", "b", "a"]
