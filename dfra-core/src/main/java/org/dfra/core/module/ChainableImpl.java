package org.dfra.core.module;

import java.util.ArrayList;
import java.util.List;
import org.dfra.flow.Chainable;
import org.dfra.persona.AttributeProvider;
import org.dfra.persona.Attributes;
import org.dfra.persona.ChainAttributes;

/** Base of every module that is a link of a chain: devices and schemas. */
public abstract class ChainableImpl extends ModuleImpl implements Chainable, AttributeProvider {

  private final ChainWiring chain;

  /**
   * See {@link ModuleImpl#ModuleImpl}.
   *
   * @param outputTypes the types it puts out, by the simple names of their classes
   */
  protected ChainableImpl(
      ModuleContext context,
      String description,
      String author,
      String version,
      List<String> outputTypes) {
    super(context, description, author, version);
    this.chain =
        new ChainWiring(context.path(), this::declaredInputTypes, outputTypes, this::onWired);
  }

  /** The types it takes in, by the simple names of their classes; always the same. */
  protected abstract List<String> declaredInputTypes();

  /**
   * It is to take its input from these modules from now on, as many as it has input types, or none
   * where it is to find them itself. Called before they count; what it throws refuses them.
   */
  protected void onWired(List<String> modules) {}

  /** What it says of itself besides its chain; from memory. */
  protected abstract List<? extends Attributes> additionalAttributes();

  /** {@inheritDoc} Its chain, and its {@link #additionalAttributes}. */
  @Override
  public final List<Attributes> attributes() {
    List<Attributes> all = new ArrayList<>();
    all.add(new ChainAttributes(inputTypes(), outputTypes()));
    all.addAll(additionalAttributes());
    return all;
  }

  @Override
  public final List<String> inputTypes() {
    return chain.inputTypes();
  }

  @Override
  public final List<String> outputTypes() {
    return chain.outputTypes();
  }

  @Override
  public final List<String> inputs() {
    return chain.inputs();
  }

  @Override
  public final List<String> outputs() {
    return chain.outputs();
  }

  @Override
  public final void setInputs(List<String> modules) {
    chain.setInputs(modules);
  }

  @Override
  public final void setOutputs(List<String> modules) {
    chain.setOutputs(modules);
  }
}
