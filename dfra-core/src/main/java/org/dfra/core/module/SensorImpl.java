package org.dfra.core.module;

import java.util.List;
import org.dfra.flow.sensor.Sensor;
import org.dfra.geometry.Transform;
import org.dfra.module.Diagnosis;
import org.dfra.module.Precondition;

/**
 * Base of every sensor's driver. It can be examined, begins a chain, and is mounted somewhere, by
 * its parameters, all of which can be set while it runs:
 *
 * <ul>
 *   <li>{@code mount_frame}: the frame it stands in; default {@code robot/base_link}
 *   <li>{@code mount_x}, {@code mount_y}, {@code mount_z}: offset in that frame, metres, −100 to
 *       100; default 0
 *   <li>{@code mount_roll}, {@code mount_pitch}, {@code mount_yaw}: turn, radians, −2π to 2π, as
 *       {@link Transform#of}; default 0
 * </ul>
 */
public abstract class SensorImpl extends ModuleImpl implements Sensor {

  private final Mount mount;
  private final Examinations examinations;
  private final ChainPlace chain;
  private final List<Precondition> preconditions;

  /** A sensor of which nothing more is known; see {@link ModuleImpl#ModuleImpl}. */
  protected SensorImpl(ModuleContext context, String description, String author, String version) {
    this(context, description, author, version, List.of(), List.of());
  }

  /**
   * See {@link ModuleImpl#ModuleImpl}.
   *
   * @param puts the types of its readings, by the simple names of their classes
   * @param preconditions what its environment must be like
   */
  protected SensorImpl(
      ModuleContext context,
      String description,
      String author,
      String version,
      List<String> puts,
      List<Precondition> preconditions) {
    super(context, description, author, version);
    this.mount = new Mount(context.robot(), context.parameters(), declared());
    this.examinations = new Examinations(context.path(), context.clock(), context.scheduler(), log);
    this.chain = new ChainPlace(context.path(), List.of(), puts, inputs -> {});
    this.preconditions = List.copyOf(preconditions);
  }

  /** Where tests and recovery methods are declared. */
  protected final Examinations examinations() {
    return examinations;
  }

  /** {@inheritDoc} A local caller never sees a {@code RemoteException}. */
  @Override
  public abstract double updateRate();

  @Override
  public final String frame() {
    return path();
  }

  @Override
  public final String parentFrame() {
    return mount.frame();
  }

  @Override
  public final Transform localTransform() {
    return mount.transform();
  }

  @Override
  public final List<Precondition> preconditions() {
    return preconditions;
  }

  @Override
  public final List<String> tests() {
    return examinations.tests();
  }

  @Override
  public final Diagnosis test(String name) {
    return examinations.runTest(name);
  }

  @Override
  public final List<String> recoveries() {
    return examinations.recoveries();
  }

  @Override
  public final Diagnosis recover(String name) {
    return examinations.runRecovery(name);
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
