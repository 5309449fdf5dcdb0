package org.dfra.core.module;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import org.dfra.core.config.Parameters;
import org.dfra.geometry.Transform;

/** The parameters of a module's mounting pose; see {@link DeviceImpl}. */
final class MountParameters {

  private static final String[] OFFSETS = {"mount_x", "mount_y", "mount_z"};
  private static final String[] ANGLES = {"mount_roll", "mount_pitch", "mount_yaw"};
  private static final double FARTHEST = 100;
  private static final double MAX_ANGLE = 2 * Math.PI;

  @GuardedBy("this")
  private final double[] values = new double[6];

  @GuardedBy("this")
  private String frame;

  private volatile Transform transform;

  MountParameters(String robot, Parameters written, ParameterTable table) {
    frame = written.find("mount_frame").orElse(robot + "/base_link");
    declareNumbers(written, table, OFFSETS, 0, FARTHEST, "m");
    declareNumbers(written, table, ANGLES, 3, MAX_ANGLE, "rad");
    table.declareText("mount_frame", "the frame it is mounted in", this::frame, this::setFrame);
    transform = computed();
  }

  @GuardedBy("this")
  private void declareNumbers(
      Parameters written,
      ParameterTable table,
      String[] names,
      int first,
      double most,
      String unit) {
    for (int i = 0; i < names.length; i++) {
      int index = first + i;
      values[index] = written.number(names[i], 0, -most, most);
      table.declareNumber(
          names[i],
          "where it is mounted in mount_frame",
          ParameterTable.NumberRange.of(-most, most, unit),
          () -> get(index),
          value -> set(index, value));
    }
  }

  synchronized String frame() {
    return frame;
  }

  Transform transform() {
    return transform;
  }

  private synchronized void setFrame(String name) {
    if (name.isBlank()) {
      throw new IllegalArgumentException("the name of a frame");
    }
    frame = name;
  }

  private synchronized double get(int index) {
    return values[index];
  }

  private synchronized void set(int index, double value) {
    values[index] = value;
    transform = computed();
  }

  @GuardedBy("this")
  private Transform computed() {
    return Transform.of(values[0], values[1], values[2], values[3], values[4], values[5]);
  }
}
