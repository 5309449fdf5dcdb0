package org.dfra.persona;

/**
 * The mounting pose of a module: its frame in the parent frame. The rotation is applied
 * intrinsically, yaw, then pitch, then roll, after the translation.
 *
 * @param frame name of the module's frame, e.g. {@code atrv1/gps_front}
 * @param parent name of the frame it is mounted on, e.g. {@code atrv1/base_link}
 * @param x translation along the parent's x in metres, forward is +
 * @param y translation along the parent's y in metres, left is +
 * @param z translation along the parent's z in metres, up is +
 * @param roll rotation about x in radians, right-handed
 * @param pitch rotation about y in radians, right-handed: nose down is +
 * @param yaw rotation about z in radians, right-handed: to the left is +
 */
public record PoseAttributes(
    String frame,
    String parent,
    double x,
    double y,
    double z,
    double roll,
    double pitch,
    double yaw)
    implements Attributes {

  public PoseAttributes {
    AttributeValidation.requireText("frame", frame);
    AttributeValidation.requireText("parent frame", parent);
    AttributeValidation.requireFinite("x", x);
    AttributeValidation.requireFinite("y", y);
    AttributeValidation.requireFinite("z", z);
    AttributeValidation.requireFinite("roll", roll);
    AttributeValidation.requireFinite("pitch", pitch);
    AttributeValidation.requireFinite("yaw", yaw);
  }
}
