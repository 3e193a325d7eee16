{-# LANGUAGE FlexibleContexts #-}
{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE MultiParamTypeClasses #-}
{-# LANGUAGE UndecidableInstances #-}

-- |
-- Module      : Rosy.Runnable
-- Description : What can be run: a controller, or a task.
--
-- A controller runs until it is stopped; a task runs until it ends. Outside tasks there is nothing for a @Done@ to end,
-- so a controller that gives one is refused before it runs.
module Rosy.Runnable
  ( -- * What it is
    Runnable (..),
  )
where

import Rosy.Command
import Rosy.Controller
import Rosy.Core

-- | Something that 'Rosy.simulate' can run.
class Runnable a where
  -- | As a program, given the names of its functions.
  program :: Names -> a -> Program ()

instance Runnable (Task end) where
  program _ tasks = runTask tasks (const (Return ()))

instance {-# OVERLAPPABLE #-} (Controller c, Ends NotInATask c) => Runnable c where
  program names c = RunTask (uncurry outside (partsOf names c)) Return

-- | Functions that are in no task, and tasks beside them.
outside :: [Function] -> [Calling] -> Spec ()
outside list tasks =
  Spec
    { specStart = Nothing,
      specFunctions = list,
      specTasks = tasks,
      specStopped = Nothing,
      specEnd = const Nothing,
      specType = "nothing: it is not in a task"
    }
