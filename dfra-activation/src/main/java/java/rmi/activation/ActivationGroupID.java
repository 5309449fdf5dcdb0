package java.rmi.activation;

import java.io.Serializable;
import java.rmi.server.UID;
import java.util.Objects;

/**
 * The identity of a registered group: unique, with a reference to the system that registered it.
 *
 * <p>Immutable.
 */
public class ActivationGroupID implements Serializable {

  private static final long serialVersionUID = -1648432278909740833L;

  /**
   * @serial the system that registered the group
   */
  private final ActivationSystem system;

  /** @serial the unique part */
  private final UID uid = new UID();

  /**
   * A new identity, different from all others.
   *
   * @param system the system in which the group is being registered
   */
  public ActivationGroupID(ActivationSystem system) {
    this.system = system;
  }

  /**
   * The system that registered the group.
   *
   * @return the system given at construction
   */
  public ActivationSystem getSystem() {
    return system;
  }

  /**
   * Computed from the unique part alone.
   *
   * @return equal for equal identities
   */
  @Override
  public int hashCode() {
    return Objects.hashCode(uid);
  }

  /**
   * Whether both name the same group of the same system.
   *
   * @param other anything
   * @return true for an ActivationGroupID with equal unique part and equal system
   */
  @Override
  public boolean equals(Object other) {
    return other instanceof ActivationGroupID that
        && Objects.equals(uid, that.uid)
        && Objects.equals(system, that.system);
  }
}
