/// The dataflow network of a program as blocks say it, and its edits: actions as values in, a new text or a refusal as a value out.

export {InferenceSession} from "../workspace/inference/inference_session.ts"
export {type DefinitionText, definitionEdit, definitionTexts} from "./definition_texts.ts"
export type {DeclaredType, NetworkAction, NetworkEdit, NetworkRefusal, NewStep} from "./network_action.ts"
export {networkEdit} from "./network_edit.ts"
export {readyName} from "./ready_functions.ts"
export {refusalSentence} from "./refusal_sentence.ts"
export type {WrittenFunction, WrittenNetwork, WrittenShape} from "./written_network.ts"
export {writtenNetwork} from "./written_network.ts"
export type {WrittenTask} from "./written_tasks.ts"
