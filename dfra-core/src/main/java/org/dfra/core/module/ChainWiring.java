package org.dfra.core.module;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.HashSet;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.regex.Pattern;

/** The current wiring of a module in its chain. */
final class ChainWiring {

  private static final Pattern PATH = Pattern.compile("[a-z][a-z0-9_]*/[a-z][a-z0-9_]*");

  private final String module;
  private final Supplier<List<String>> inputTypes;
  private final List<String> outputTypes;
  private final Consumer<List<String>> rewired;

  @GuardedBy("this")
  private List<String> inputs = List.of();

  private volatile List<String> outputs = List.of();

  /**
   * @param module the module's path, {@code robot/name}
   * @param inputTypes returns its input types, always the same
   * @param outputTypes its output types
   * @param rewired receives its new inputs before they become effective
   */
  public ChainWiring(
      String module,
      Supplier<List<String>> inputTypes,
      List<String> outputTypes,
      Consumer<List<String>> rewired) {
    this.module = module;
    this.inputTypes = inputTypes;
    this.outputTypes = List.copyOf(outputTypes);
    this.rewired = rewired;
  }

  /** See {@link org.dfra.flow.Chainable#inputTypes}. */
  public List<String> inputTypes() {
    return List.copyOf(inputTypes.get());
  }

  /** See {@link org.dfra.flow.Chainable#outputTypes}. */
  public List<String> outputTypes() {
    return outputTypes;
  }

  /** See {@link org.dfra.flow.Chainable#inputs}. */
  public synchronized List<String> inputs() {
    return inputs;
  }

  /** See {@link org.dfra.flow.Chainable#outputs}. */
  public List<String> outputs() {
    return outputs;
  }

  /** See {@link org.dfra.flow.Chainable#setInputs}. */
  public synchronized void setInputs(List<String> modules) {
    List<String> wanted = List.copyOf(modules);
    if (!wanted.isEmpty() && wanted.size() != inputTypes().size()) {
      throw new IllegalArgumentException(
          module
              + " takes "
              + (inputTypes().isEmpty()
                  ? "no input; give it none"
                  : inputTypes().size()
                      + " inputs ("
                      + String.join(", ", inputTypes())
                      + ") or none")
              + ", but was given "
              + wanted.size());
    }
    wanted.forEach(this::check);
    if (!wanted.equals(inputs)) {
      rewired.accept(wanted);
      inputs = wanted;
    }
  }

  /** See {@link org.dfra.flow.Chainable#setOutputs}. */
  public void setOutputs(List<String> modules) {
    List<String> wanted = List.copyOf(modules);
    if (!wanted.isEmpty() && outputTypes.isEmpty()) {
      throw new IllegalArgumentException(module + " has no output; wire it to nothing");
    }
    wanted.forEach(this::check);
    if (new HashSet<>(wanted).size() != wanted.size()) {
      throw new IllegalArgumentException(
          module + " was given one output twice in " + wanted + "; name each once");
    }
    outputs = wanted;
  }

  private void check(String path) {
    if (!PATH.matcher(path).matches()) {
      throw new IllegalArgumentException(
          module
              + " cannot be wired to \""
              + path
              + "\", which is not the path of a module; write robot/name");
    }
    if (path.equals(module)) {
      throw new IllegalArgumentException(module + " cannot be wired to itself");
    }
  }
}
