{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Rosy.Worker.Ghc.DeclarationWarnings
-- Description : Warnings about declarations that compile, but take away a meaning or add none.
--
-- A declared type hides Rosy's type of the same name (rule R20), and then nothing is remembered by a @Memory@ of the program's own. An instance of
-- @Sensor@ or @Command@ without methods does not say where the values come from or go to. Both are read off the parsed tree.
module Rosy.Worker.Ghc.DeclarationWarnings
  ( declarationWarnings,
  )
where

import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import GHC.Data.Bag (isEmptyBag)
import GHC.Hs hiding (Warning)
import GHC.Types.Name.Occurrence (mkDataOccFS, occNameFS, occNameString)
import GHC.Types.Name.Reader (RdrName, mkRdrUnqual, rdrNameOcc)
import GHC.Types.SrcLoc
import Rosy.Worker.Ghc.Compat.Declarations
import Rosy.Worker.Ghc.Compat.Syntax
import Rosy.Worker.Ghc.DeclaredTypes (instanceHead)
import Rosy.Worker.Ghc.TreeRewrite (ImplicitNames (..))
import Rosy.Worker.Problem hiding (Declaration)
import Rosy.Worker.Sentence

-- | In source order. Takes the text of a span, for fixes.
declarationWarnings :: (SrcSpan -> Maybe Span) -> ImplicitNames -> SyntaxTree -> [Problem]
declarationWarnings located implicitNames parsed = concat [warning s (unLoc l) | l <- hsmodDecls parsed, Just s <- [located (spanOf l)]]
  where
    warning :: Span -> HsDecl GhcPs -> [Problem]
    warning s d = case d of
      TyClD _ t@DataDecl {} | n <- unLoc (tcdLName t), rdrNameOcc n `Set.member` robotTypes implicitNames, not (isConnected (plain n)) -> [(if isCopy t then removing s else asWarning) (hides s (plain n))]
      InstD _ (ClsInstD _ i)
        | isEmptyBag (cid_binds i), (c, t) : _ <- instanceHead d, c `elem` ["Sensor", "Command"] -> [empty s (Text.pack c) (Text.pack t)]
      _ -> []
    -- A type with a topic of its own is not mistaken for the robot's.
    isConnected t = or [not (isEmptyBag (cid_binds i)) | L _ d@(InstD _ (ClsInstD _ i)) <- hsmodDecls parsed, (c, n) <- instanceHead d, c `elem` ["Sensor", "Command"], Text.pack n == t]
    declared = [plain (unLoc (tcdLName t)) | L _ (TyClD _ t@DataDecl {}) <- hsmodDecls parsed]

    -- As a paper shows the library's own: data Memory a = Memory a.
    isCopy t = plain (unLoc (tcdLName t)) `elem` ["Memory", "Param", "Done"] && length (hsQTvExplicit (tcdTyVars t)) == 1 && concatMap (constructorNames . unLoc) (dataConstructors (tcdDataDefn t)) == [mkRdrUnqual (mkDataOccFS (occNameFS (rdrNameOcc (unLoc (tcdLName t)))))]
    hides s n = problemAt s "hides-rosy" (trWith "This ‘{name}’ hides the one that Rosy has." ["name" =: n]) (consequence n)
    consequence n
      | n `elem` ["Memory", "Param"] = tr "With it nothing is remembered: remove it, or give it another name."
      | n == "Done" = tr "With it no task ends: remove it, or give it another name."
      | n == "Task" = tr "With it there are no tasks: remove it, or give it another name."
      | otherwise = tr "The robot knows only its own: remove it, or give it another name."

    empty s c t
      | t `elem` declared = removing s (problemAt s "empty-instance" (trWith "This declaration adds nothing: ‘{type}’ is an event already." ["type" =: t]) (trWith "One function gives it, another takes it: remove the declaration. If it is a message of a robot, write after it: {code}" ["code" =: methodOf c t]))
      | otherwise = asWarning (problemAt s "empty-instance" (if c == "Sensor" then trWith "This declaration does not say where values of ‘{type}’ come from." ["type" =: t] else trWith "This declaration does not say where values of ‘{type}’ go to." ["type" =: t]) (trWith "To send them from function to function, declare a type: newtype My{type} = My{type} {type}" ["type" =: t]))
    -- The method of the instance, as rule R23 has it.
    methodOf c t
      | c == "Sensor" = "where sensor = topic \"/name\" \"package/Type\" (" <> t <> " <$> field \"name\")"
      | otherwise = "where command = publish \"/name\" \"package/Type\" (\\_ -> [(\"name\", whole 1)])"
    asWarning p = p {severity = Warning}
    removing s p = (asWarning p) {fixes = [Fix (tr "Remove this declaration") [Edit (Span (start s) (Position (line (end s) + 1) 1)) ""] | column (start s) == 1]}
    plain :: RdrName -> Text
    plain = Text.pack . occNameString . rdrNameOcc
