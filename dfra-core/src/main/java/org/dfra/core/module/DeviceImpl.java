package org.dfra.core.module;

import java.util.ArrayList;
import java.util.List;
import org.dfra.flow.Device;
import org.dfra.geometry.Transform;
import org.dfra.module.Diagnosis;
import org.dfra.module.Precondition;
import org.dfra.persona.Attributes;
import org.dfra.persona.PoseAttributes;

/**
 * Base of every driver of hardware, through {@link SensorImpl} or {@link
 * org.dfra.core.effector.EffectorImpl}. It has diagnostics, a place in a chain, and a mounting
 * pose. The pose is set by parameters, all of which can be changed while it runs:
 *
 * <ul>
 *   <li>{@code mount_frame}: the parent frame; default {@code robot/base_link}
 *   <li>{@code mount_x}, {@code mount_y}, {@code mount_z}: offset in that frame, metres, −100 to
 *       100; default 0
 *   <li>{@code mount_roll}, {@code mount_pitch}, {@code mount_yaw}: rotation, radians, −2π to 2π,
 *       as {@link Transform#of}; default 0
 * </ul>
 */
public abstract class DeviceImpl extends ChainableImpl implements Device {

  private final List<String> takes;
  private final MountParameters mount;
  private final Diagnostics examinations;
  private final List<Precondition> preconditions;

  /**
   * See {@link ModuleImpl#ModuleImpl}.
   *
   * @param inputTypes its input types, by the simple names of their classes
   * @param outputTypes the types of its readings, by the simple names of their classes
   * @param preconditions the required conditions of its environment
   */
  protected DeviceImpl(
      ModuleContext context,
      String description,
      String author,
      String version,
      List<String> inputTypes,
      List<String> outputTypes,
      List<Precondition> preconditions) {
    super(context, description, author, version, outputTypes);
    this.takes = List.copyOf(inputTypes);
    this.mount = new MountParameters(context.robot(), context.parameters(), parameterTable());
    this.examinations = new Diagnostics(context.path(), context.clock(), context.scheduler(), log);
    this.preconditions = List.copyOf(preconditions);
  }

  @Override
  protected final List<String> declaredInputTypes() {
    return takes;
  }

  /** Declares tests and recovery methods. */
  protected final Diagnostics diagnostics() {
    return examinations;
  }

  /**
   * Its attributes besides those of its chain and its mount; called several times a second, so it
   * returns cached values.
   */
  protected abstract List<? extends Attributes> deviceAttributes();

  /**
   * The attributes of every device of its category, besides {@link #deviceAttributes}; cached as
   * well.
   */
  protected List<? extends Attributes> categoryAttributes() {
    return List.of();
  }

  /** {@inheritDoc} Its mount, its category's attributes, and its {@link #deviceAttributes}. */
  @Override
  protected final List<Attributes> additionalAttributes() {
    List<Attributes> all = new ArrayList<>();
    Transform at = mount.transform();
    all.add(
        new PoseAttributes(
            frame(), parentFrame(), at.x(), at.y(), at.z(), at.roll(), at.pitch(), at.yaw()));
    all.addAll(categoryAttributes());
    all.addAll(deviceAttributes());
    return all;
  }

  @Override
  public final String frame() {
    return path();
  }

  @Override
  public final String parentFrame() {
    return mount.frame();
  }

  /** {@inheritDoc} This is its mount; a device whose frame moves overrides this. */
  @Override
  public Transform localTransform() {
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
}
