{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Module      : Rosy.Worker.Ghc.Parsing
-- Description : Parsing of programs, and refusal of what programs may not contain.
module Rosy.Worker.Ghc.Parsing
  ( -- * Reading
    programOptions,
    readProgram,

    -- * Refusing
    Restriction (..),
    treeRefusals,
    unsafeImports,
    onLinesContaining,
    onLinesApplying,

    -- * For the type checker
    summaryOf,
  )
where

import Data.Bifunctor (first)
import Data.Char (isAlpha, isDigit, isLower, isUpper)
import Data.Data (Data, cast, gmapQ)
import qualified Data.IntSet as IntSet
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import GHC.Data.StringBuffer (StringBuffer, stringToStringBuffer)
import GHC.Driver.Session (DynFlags, xopt_set)
import GHC.Hs hiding (Warning)
import GHC.LanguageExtensions.Type (Extension (DerivingVia, GeneralizedNewtypeDeriving))
import GHC.Types.Name.Occurrence (occNameString)
import GHC.Types.Name.Reader (isQual, rdrNameOcc)
import GHC.Types.SrcLoc
import GHC.Unit.Module (moduleNameString)
import Rosy.Worker.Allowlist
import Rosy.Worker.CompilerMessage (CompilerMessage (..))
import Rosy.Worker.Ghc.Compat.Driver
import Rosy.Worker.Ghc.Compat.Syntax
import Rosy.Worker.Ghc.Declarations
import Rosy.Worker.Ghc.Diagnostics
import Rosy.Worker.Problem (Position (..), Problem, Span (..), problemAt, problemNowhere)
import Rosy.Worker.Refusals
import Rosy.Worker.Sentence
import Rosy.Worker.TabStops (TabStops)

-- | Restriction of imports and extensions: allowlists and Safe Haskell, Safe Haskell only, or none. Weaker restrictions are used only by
-- tests of the other protections.
data Restriction = Restricted | SafeHaskellOnly | Unrestricted
  deriving (Eq)

-- | The flags after the pragmas at the top of the file, or the refused pragmas.
programOptions :: Restriction -> DynFlags -> TabStops -> Text -> StringBuffer -> IO (Either [Problem] DynFlags)
programOptions restriction _ _ source _ | restriction == Restricted, found@(_ : _) <- linePragmaRefusals source = pure (Left found)
programOptions restriction flags columns _ buffer = do
  pragmas <- readPragmas flags buffer fileName
  case pragmas of
    Left diagnostics -> pure (Left (map optionProblem diagnostics))
    Right options -> case if restriction == Restricted then concatMap refusal options else [] of
      [] -> fmap withCoercedInstances . first (map optionProblem) <$> applyPragmas flags options
      found -> pure (Left found)
  where
    -- Safe Haskell switches these off although they give no more than Data.Coerce, which is allowed: all obey roles.
    withCoercedInstances applied = foldl xopt_set applied [GeneralizedNewtypeDeriving, DerivingVia]
    refusal (L at option) = case option of
      '-' : 'X' : extension
        | isAllowedExtension (Text.pack extension) -> []
        | otherwise -> [at `sayWith` ("extension", refuseExtension (Text.pack extension))]
      _ -> [at `sayWith` ("options", refuseOptions)]
    sayWith at (k, (m, h)) = say columns at k m h
    optionProblem diagnostic =
      let raw = fromParser flags columns diagnostic
          (m, h) = refuseUnknown (unknownExtension (Text.unwords (Text.words (Text.unwords (important raw)))))
       in maybe (problemNowhere "extension") (`problemAt` "extension") (messageSpan raw) m h
    unknownExtension message = Text.takeWhile (`notElem` (" \8217\n" :: String)) (Text.dropWhile (`elem` (" \8216" :: String)) (snd (Text.breakOnEnd "Unsupported extension:" message)))

-- | Refuses line pragmas. They would shift the positions of problems, and 'onLinesContaining' would inspect the wrong lines.
linePragmaRefusals :: Text -> [Problem]
linePragmaRefusals source = [problemAt (Span (Position n 1) (Position n (Text.length l + 1))) "pragma" (tr "A program cannot say on which line it is.") (tr "Remove this line.") | (n, l) <- numbered, n `elem` hashes ++ pragmas]
  where
    numbered = zip [1 ..] (Text.lines source)
    hashes = [n | (n, l) <- numbered, Just rest <- [Text.stripPrefix "#" l], let word = Text.stripStart rest, Text.any isDigit (Text.take 1 word) || "line" `Text.isPrefixOf` word]
    pragmas = [1 + Text.count "\n" before | (before, after) <- Text.breakOnAll "{-#" source, Text.toLower (Text.takeWhile isAlpha (Text.stripStart (Text.drop 3 after))) `elem` ["line", "column"]]

-- | The syntax tree with warnings of the parser, or its errors.
readProgram :: DynFlags -> TabStops -> StringBuffer -> Either [CompilerMessage] (Located SyntaxTree, [CompilerMessage])
readProgram flags columns buffer = case parseText flags buffer fileName of
  Left errors -> Left (map (fromParser flags columns) errors)
  Right (tree, warnings) -> Right (tree, map (fromParser flags columns) warnings)

fileName :: FilePath
fileName = "Main.hs"

say :: TabStops -> SrcSpan -> Text -> Sentence -> Sentence -> Problem
say columns s k m h = maybe (problemNowhere k m h) (\p -> problemAt p k m h) (spanAt columns s)

-- | Everything that is refused independently of types.
treeRefusals :: TabStops -> Text -> SyntaxTree -> [Problem]
treeRefusals columns source parsed = importRefusals columns parsed ++ declarationRefusals columns source parsed ++ nameRefusals columns (onLinesContaining refusedNames source) parsed

-- | Imports that are neither on the allowlist nor safe. The allowlist has modules that Safe Haskell cannot infer, Rosy among them.
unsafeImports :: HscEnv -> TabStops -> SyntaxTree -> IO [Problem]
unsafeImports env columns parsed = concat <$> mapM judged (hsmodImports parsed)
  where
    judged (At s i) = do
      found <- findModuleNamed env (moduleNameString (unLoc (ideclName i)))
      -- The type checker reports unknown modules.
      safe <- maybe (pure True) (\m -> isSafeImport env m s) found
      let name = Text.pack (moduleNameString (unLoc (ideclName i)))
          (m, h) = refuseModule name
      pure [say columns s "import" m h | not safe, not (isAllowedModule name)]

importRefusals :: TabStops -> SyntaxTree -> [Problem]
importRefusals columns parsed =
  [ say columns s "import" m h
    | At s i <- hsmodImports parsed,
      let wanted = Text.pack (moduleNameString (unLoc (ideclName i))),
      not (isAllowedModule wanted),
      let (m, h) = refuseModule wanted
  ]

-- | Whether a span contains a line with one of these words. Searching the text is faster than walking the tree.
onLinesContaining :: [Text] -> Text -> SrcSpan -> Bool
onLinesContaining words' source = onLines (\l -> any (`Text.isInfixOf` l) there) (if null there then Text.empty else source)
  where
    there = filter (`Text.isInfixOf` source) words'

-- | Whether a span contains a line where one of these names has something behind it, other than at the left edge, where it is defined.
onLinesApplying :: [Text] -> Text -> SrcSpan -> Bool
onLinesApplying names = onLines (applied . Text.split (== ' '))
  where
    wanted = Set.fromList names
    -- All but the last have a space behind them.
    applied parts = case parts of
      leftmost : rest@(_ : _) -> isCall leftmost || any isWord (init rest)
      _ -> False
    isWord = (`Set.member` wanted) . afterBracket
    isCall part = let word = afterBracket part in Text.length word < Text.length part && word `Set.member` wanted
    afterBracket = Text.takeWhileEnd (`notElem` ("([," :: String))

-- | Whether a span contains one of the lines that are asked for. To be applied to all but the span once: the lines are then searched once.
onLines :: (Text -> Bool) -> Text -> SrcSpan -> Bool
onLines isWanted source = \case
  RealSrcSpan s _ -> maybe False (<= srcSpanEndLine s) (IntSet.lookupGE (srcSpanStartLine s) found)
  UnhelpfulSpan _ -> False
  where
    -- Shared by all spans, therefore outside of the lambda.
    found = IntSet.fromDistinctAscList [n | (n, l) <- zip [1 ..] (Text.lines source), isWanted l]

-- | Declarations that are refused whatever extensions are on.
declarationRefusals :: TabStops -> Text -> SyntaxTree -> [Problem]
declarationRefusals columns source parsed = concatMap refusal (hsmodDecls parsed)
  where
    lineAt s = case s of
      RealSrcSpan r _ -> Text.concat (take 1 (drop (srcSpanStartLine r - 1) (Text.lines source)))
      UnhelpfulSpan _ -> Text.empty
    noDefinition s = case Text.words (lineAt s) of
      f : ":" : _ -> (tr "Two colons go between a name and its type.", trWith "Write: {name} :: …" ["name" =: f])
      w : _ | w `elem` ["def", "function", "func", "fun", "var", "const", "void"] -> (trWith "‘{word}’ means nothing in Haskell." ["word" =: w], definition "Velocity 0.5 0")
      w : _ | isOverLines s, begins isLower w -> (tr "At the end of this line an equals sign is missing.", trWith "Write: {code} = …" ["code" =: Text.stripEnd (lineAt s)])
      w : value@(c : _) | begins isLower w, begins isUpper c, not (Text.any (== ',') (Text.concat value)) -> (tr "This line has no equals sign.", trWith "Write: {code}" ["code" =: w <> " = " <> Text.unwords value])
      w : _ | begins isLower w -> (tr "This line has no equals sign.", definition "Velocity 0.5 0")
      _ -> (tr "This line has no equals sign.", definition (Text.strip (lineAt s)))
    -- The program's own value, if it is short.
    definition value
      | Text.length value > 40 = tr "A definition is a name, an equals sign and a value: move = …"
      | otherwise = trWith "A definition is a name, an equals sign and a value: move = {value}" ["value" =: value]
    begins p = maybe False (p . fst) . Text.uncons
    isOverLines s = case s of
      RealSrcSpan r _ -> srcSpanStartLine r < srcSpanEndLine r
      UnhelpfulSpan _ -> False
    refusal (At s d) = case d of
      ForD {} -> [say columns s "foreign" (tr "A program cannot call functions of other languages.") (tr "A robot program is all Haskell.")]
      SpliceD {} -> [uncurry (say columns s "missing-equals") (noDefinition s)]
      RuleD {} -> [say columns s "pragma" (tr "A program cannot change how it is compiled.") (tr "Remove these rules.")]
      AnnD {} -> [say columns s "pragma" (tr "A program cannot change how it is compiled.") (tr "Remove this annotation.")]
      _ -> []

-- | Prelude functions with access to files and input, with any qualifier. A function of the same name defined by the program is allowed.
nameRefusals :: TabStops -> (SrcSpan -> Bool) -> SyntaxTree -> [Problem]
nameRefusals columns suspicious parsed = concat [gmapQ' d | d <- hsmodDecls parsed, suspicious (spanOf d)]
  where
    gmapQ' d = concat (gmapQ uses d)
    own = map fst (definitionSpans (spanAt columns) parsed)
    uses :: Data a => a -> [Problem]
    uses x = case cast x of
      Just (At s (HsVar _ (L _ n)) :: LHsExpr GhcPs)
        | used <- Text.pack (occNameString (rdrNameOcc n)),
          Just (m, h) <- refuseName used,
          isQual n || used `notElem` own ->
          [say columns s "not-allowed" m h]
      _ -> concat (gmapQ uses x)

-- | The module that the type checker is given.
summaryOf :: HscEnv -> Text -> ModSummary
summaryOf env source = mainSummary env fileName (stringToStringBuffer (Text.unpack source))
