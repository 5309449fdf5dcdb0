package org.dfra.core.module;

import java.util.ArrayList;
import java.util.List;
import org.dfra.flow.Chainable;
import org.dfra.persona.AttributeProvider;
import org.dfra.persona.Attributes;
import org.dfra.persona.ChainAttributes;

/** Base of every module in a processing chain: devices and schemas. */
abstract class ChainableImpl extends ModuleImpl implements Chainable, AttributeProvider {

  private final ChainWiring chain;

  /**
   * See {@link ModuleImpl#ModuleImpl}.
   *
   * @param outputTypes its output types, by the simple names of their classes
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

  /** Its input types, by the simple names of their classes; always the same. */
  protected abstract List<String> declaredInputTypes();

  /**
   * Called when the inputs are wired to these modules, one per input type, or none if the module
   * shall find them itself. Called before they become effective; an exception refuses them.
   */
  protected void onWired(List<String> modules) {}

  /** Its attributes besides those of its chain; cached values. */
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
