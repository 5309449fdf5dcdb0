package org.dfra.core.module;

import java.util.List;
import java.util.Optional;
import org.dfra.core.chain.ChainInputs;
import org.dfra.core.chain.ChainInputs.ReadingConsumer;
import org.dfra.core.chain.ChainInputs.SequencedReadingConsumer;
import org.dfra.directory.ModuleQuery;
import org.dfra.event.Reading;
import org.dfra.flow.Schema;
import org.dfra.module.Module;

/**
 * Base of every schema: software between sensors and effectors. Its constructor declares its inputs
 * by {@link #declareInput}. From its start on it receives the readings of its robot's modules of
 * these types, or of the modules that it is wired to.
 */
public abstract class SchemaImpl extends ChainableImpl implements Schema {

  private final ModuleContext context;
  private final ChainInputs inputs;

  /**
   * See {@link ModuleImpl#ModuleImpl}.
   *
   * @param outputTypes its output types, by the simple names of their classes
   */
  protected SchemaImpl(
      ModuleContext context,
      String description,
      String author,
      String version,
      List<String> outputTypes) {
    super(context, description, author, version, outputTypes);
    this.context = context;
    this.inputs = new ChainInputs(context.path(), context::directory, context.scheduler(), log);
  }

  /** The context from its construction. */
  protected final ModuleContext context() {
    return context;
  }

  /**
   * Declares the next input, in the constructor only: one module of its own robot.
   *
   * @param kind the type of module; a parameter of the schema may name one
   * @param parameter the parameter that names the module; if it is not set, the first of the type
   *     is used
   * @param type the type of readings that it consumes
   * @param consumer receives each reading
   */
  protected final <M extends Module, R extends Reading> void declareInput(
      Class<M> kind, String parameter, Class<R> type, ReadingConsumer<? super R> consumer) {
    ModuleQuery<M> any = ModuleQuery.of(kind).robot(context.robot());
    inputs.declareOne(
        context.parameters().moduleName(parameter, kind).map(any::name).orElse(any),
        context
            .parameters()
            .place(parameter)
            .map(place -> ", which " + place + " names")
            .orElse(""),
        type,
        (source, sequence, reading) -> consumer.accept(source, reading));
  }

  /** The same with all modules of that type on its own robot. */
  protected final <M extends Module, R extends Reading> void declareInputFromAll(
      Class<M> kind, Class<R> type, ReadingConsumer<? super R> taker) {
    inputs.declareAll(
        ModuleQuery.of(kind).robot(context.robot()),
        type,
        (source, sequence, reading) -> taker.accept(source, reading));
  }

  /** The same with all modules that match, on any robot. */
  protected final <M extends Module, R extends Reading> void declareInputFromTeam(
      ModuleQuery<M> which, Class<R> type, SequencedReadingConsumer<? super R> taker) {
    inputs.declareAll(which, type, taker);
  }

  /** The missing input modules, as a clause; empty if all are available. */
  protected final Optional<String> missingInput() {
    return inputs.missing();
  }

  @Override
  protected final List<String> declaredInputTypes() {
    return inputs.types();
  }

  @Override
  protected final void onWired(List<String> modules) {
    inputs.wire(modules);
  }

  /** {@inheritDoc} An overriding method must call this one. */
  @Override
  protected void onStart() {
    inputs.wire(inputs());
  }

  /** {@inheritDoc} An overriding method must call this one. */
  @Override
  protected void onClose() {
    inputs.close();
  }
}
