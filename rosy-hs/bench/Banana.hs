{-# LANGUAGE LambdaCase #-}

-- |
-- Module      : Banana
-- Description : The same network with reactive-banana.
--
-- Events for odometry, bumps and ticks; a behaviour for what was hit; outputs are added up, as Rosy's are.
module Banana
  ( runBanana,
  )
where

import Data.IORef
import Network (Stimulus (..), Tally (..))
import Reactive.Banana
import Reactive.Banana.Frameworks

runBanana :: [Stimulus] -> IO Tally
runBanana todo = do
  tally <- newIORef (Tally 0 0 0)
  (addOdom, fireOdom) <- newAddHandler
  (addBump, fireBump) <- newAddHandler
  (addTick, fireTick) <- newAddHandler
  network <- compile $ do
    odom <- fromAddHandler addOdom
    bump <- fromAddHandler addBump
    ticks <- fromAddHandler addTick
    hit <- stepper False bump
    counter <- accumB (0 :: Int) ((+ 1) <$ ticks)
    let accelerate backwards v = if backwards then v - 0.5 else v + 0.5
        speed = accelerate <$> hit <@> odom
        sound = filterE id bump
    reactimate ((\v -> modifyIORef' tally (\t -> t {speeds = speeds t + 1, total = total t + v})) <$> speed)
    reactimate (modifyIORef' tally (\t -> t {sounds = sounds t + 1}) <$ sound)
    -- The counter is no output in Rosy either, but it is computed.
    reactimate ((\n -> n `seq` pure ()) <$> (counter <@ ticks))
  actuate network
  mapM_ (\case Odom v -> fireOdom v; Bump b -> fireBump b; Ticked -> fireTick ()) todo
  readIORef tally
