#pragma once
#include <solitaire/error.h>
#include <vector>

#include "base/diagnostic.h"
#include "base/file_error.h"
#include "base/stop_signal.h"
#include "engines/errors.h"
#include "scene/error.h"

namespace solitaire::api {

std::vector<Diagnostic> public_diagnostics(const std::vector<solitaire::Diagnostic>& diagnostics,
                                           const SourceSet& sources);

/// Returns the public error that says the same; its spans are of `sources`.
Error error_of(Error::Kind kind, const ProgramError& error, const SourceSet& sources);

/// Returns the error about a thing, at its place call.
Error error_of(const ThingError& error, const SourceSet& sources);

/// Does some work on a program with these sources, and throws the public error in place of one that engines
/// and scenes throw.
template <class Work>
auto translated(const SourceSet& sources, const Work& work) {
  try {
    return work();
  } catch (const ProgramError& error) {
    throw error_of(Error::Kind::kProgram, error, sources);
  } catch (const Interrupted& error) {
    throw Error(Error::Kind::kStopped, error.what());
  } catch (const InternalError& error) {
    throw Error(Error::Kind::kInternal, error.what());
  } catch (const UnmatchedPin& error) {
    throw Error(Error::Kind::kUsage, error.what());
  } catch (const NoTileMap& error) {
    throw Error(Error::Kind::kUsage, error.what());
  } catch (const UnequalSolutions& error) {
    throw Error(Error::Kind::kUsage, error.what());
  } catch (const FileError& error) {
    throw Error(Error::Kind::kFile, error.what());
  } catch (const ThingError& error) {
    throw error_of(error, sources);
  } catch (const SceneError& error) {
    throw Error(Error::Kind::kFile, error.what());
  }
}

}  // namespace solitaire::api
