package java.rmi.activation;

import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serializable;
import java.rmi.MarshalledObject;
import java.util.Objects;

/**
 * How to construct an activatable object: its group, class, codebase and data, and whether the
 * daemon restarts it automatically.
 *
 * <p>Immutable.
 */
public final class ActivationDesc implements Serializable {

  private static final long serialVersionUID = 7455834104417690957L;

  /**
   * @serial in which group
   */
  private final ActivationGroupID groupID;

  /**
   * @serial the object's class
   */
  private final String className;

  /**
   * @serial the codebase of the class: URLs separated by spaces, or null
   */
  private final String location;

  /**
   * @serial the argument of the object's constructor, or null
   */
  private final MarshalledObject<?> data;

  /**
   * @serial whether the object is activated when the daemon starts and after a crash of its group
   */
  private final boolean restart;

  /**
   * For an object of this JVM's group, activated on demand only.
   *
   * @param className the object's class, fully qualified
   * @param location the codebase of the class: URLs separated by spaces, or null
   * @param data the argument of the object's constructor, or null
   * @throws ActivationException if this JVM has no activation group
   */
  public ActivationDesc(String className, String location, MarshalledObject<?> data)
      throws ActivationException {
    this(className, location, data, false);
  }

  /**
   * For an object of this JVM's group.
   *
   * @param className the object's class, fully qualified
   * @param location the codebase of the class: URLs separated by spaces, or null
   * @param data the argument of the object's constructor, or null
   * @param restart true: activated when the daemon starts and after a crash of its group; false: on
   *     demand only
   * @throws ActivationException if this JVM has no activation group
   */
  public ActivationDesc(
      String className, String location, MarshalledObject<?> data, boolean restart)
      throws ActivationException {
    this(groupOfThisJvm(className), className, location, data, restart);
  }

  /**
   * For an object of any group, activated on demand only.
   *
   * @param groupID the group in whose JVM the object is constructed
   * @param className the object's class, fully qualified
   * @param location the codebase of the class: URLs separated by spaces, or null
   * @param data the argument of the object's constructor, or null
   * @throws IllegalArgumentException if the group is null
   */
  public ActivationDesc(
      ActivationGroupID groupID, String className, String location, MarshalledObject<?> data) {
    this(groupID, className, location, data, false);
  }

  /**
   * For an object of any group.
   *
   * @param groupID the group in whose JVM the object is constructed
   * @param className the object's class, fully qualified
   * @param location the codebase of the class: URLs separated by spaces, or null
   * @param data the argument of the object's constructor, or null
   * @param restart true: activated when the daemon starts and after a crash of its group; false: on
   *     demand only
   * @throws IllegalArgumentException if the group is null
   */
  public ActivationDesc(
      ActivationGroupID groupID,
      String className,
      String location,
      MarshalledObject<?> data,
      boolean restart) {
    if (groupID == null) {
      throw new IllegalArgumentException(
          "The descriptor of "
              + className
              + " has no group: give the ActivationGroupID that registerGroup returned.");
    }
    this.groupID = groupID;
    this.className = className;
    this.location = location;
    this.data = data;
    this.restart = restart;
  }

  private static ActivationGroupID groupOfThisJvm(String className) throws ActivationException {
    ActivationGroupID current = ActivationGroup.currentGroupID();
    if (current == null) {
      throw new ActivationException(
          "The descriptor of "
              + className
              + " has no group, and this JVM has no active group: give an ActivationGroupID,"
              + " or call ActivationGroup.createGroup first.");
    }
    return current;
  }

  /**
   * The group in whose JVM the object is constructed.
   *
   * @return the group, never null
   */
  public ActivationGroupID getGroupID() {
    return groupID;
  }

  /**
   * The object's class.
   *
   * @return its fully qualified name
   */
  public String getClassName() {
    return className;
  }

  /**
   * The codebase of the class.
   *
   * @return URLs separated by spaces, or null
   */
  public String getLocation() {
    return location;
  }

  /**
   * The argument of the object's constructor.
   *
   * @return the data, still marshalled, or null
   */
  public MarshalledObject<?> getData() {
    return data;
  }

  /**
   * Whether the daemon activates the object automatically.
   *
   * @return true: when the daemon starts and after a crash of its group; false: on demand only
   */
  public boolean getRestartMode() {
    return restart;
  }

  /**
   * Whether both descriptors are equal.
   *
   * @param other anything
   * @return true for an ActivationDesc equal in group, class, location, data and restart mode
   */
  @Override
  public boolean equals(Object other) {
    return other instanceof ActivationDesc that
        && restart == that.restart
        && Objects.equals(groupID, that.groupID)
        && Objects.equals(className, that.className)
        && Objects.equals(location, that.location)
        && Objects.equals(data, that.data);
  }

  /**
   * Computed from all parts.
   *
   * @return equal for equal descriptors
   */
  @Override
  public int hashCode() {
    return Objects.hash(groupID, className, location, data, restart);
  }

  private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
    in.defaultReadObject();
    if (groupID == null) {
      throw new InvalidObjectException(
          "A descriptor of " + className + " without a group was read.");
    }
  }
}
