package org.dfra.river.phoenix;

import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationInstantiator;
import java.rmi.server.UID;
import java.util.HashSet;
import java.util.Set;
import org.dfra.river.phoenix.GroupStatus.State;
import org.jspecify.annotations.Nullable;

/**
 * One life of a group's process: what is known of it, along the arrows that are drawn at {@link
 * State}. It leaves the states of a process only when that process is proven dead, and does not
 * come back: what is launched next is another incarnation. Confined to the group's lock.
 */
final class Incarnation {

  private final long number;
  private State state;
  private @Nullable ProcessIdentity process;
  private @Nullable ActivationInstantiator instantiator; // there is one while it is ACTIVE
  private boolean adopted;
  private boolean hasLaunchPermit; // holds one of the daemon's turns to start
  private final Set<UID> unregistered = new HashSet<>(); // while its process may have had them

  private Incarnation(long number, State state) {
    this.number = number;
    this.state = state;
  }

  /** One that has ended, or 0 where there was none yet. */
  static Incarnation past(long number) {
    return new Incarnation(number, State.IDLE);
  }

  /** The one after this: its process is about to be launched. */
  Incarnation next() {
    return new Incarnation(number + 1, State.STARTING);
  }

  /** Its process was launched, by one of the daemon's turns. */
  void launched(ProcessIdentity started) {
    process = started;
    hasLaunchPermit = true;
  }

  /**
   * A former daemon launched it, and its process lives.
   *
   * @param known the instantiator that it reported, if it did
   * @param leaving whether it said that it ends
   */
  void adopt(ProcessIdentity found, @Nullable ActivationInstantiator known, boolean leaving) {
    process = found;
    adopted = true;
    instantiator = leaving ? null : known;
    state = leaving ? State.LEAVING : known == null ? State.STARTING : State.ACTIVE;
  }

  /**
   * Whether this very report was made before; false where it may be made now.
   *
   * @param group the group's name, for messages
   * @throws ActivationException if the reporter is of another incarnation or too late, or another
   *     one has reported before it
   */
  boolean isRepeatedReport(String group, ActivationInstantiator reporter, long itsNumber)
      throws ActivationException {
    if (itsNumber != number || state == State.IDLE || state == State.LEAVING) {
      throw new ActivationException(
          "incarnation "
              + itsNumber
              + " of group "
              + group
              + " is refused: the daemon knows incarnation "
              + number
              + " as "
              + state);
    }
    if (state == State.ACTIVE && !reporter.equals(instantiator)) {
      throw new ActivationException("group " + group + " already has an instantiator");
    }
    return state == State.ACTIVE;
  }

  /** Its process makes objects. */
  void reported(ActivationInstantiator reporter) {
    instantiator = reporter;
    state = State.ACTIVE;
  }

  /** Its process makes no more objects, and will end. */
  void setLeaving() {
    instantiator = null;
    state = State.LEAVING;
  }

  /** Its process is dead, or was never launched. */
  void ended() {
    state = State.IDLE;
    process = null;
    instantiator = null;
    adopted = false;
    unregistered.clear();
  }

  /** An object was unregistered that its process may have. */
  void addUnregistered(UID object) {
    if (state != State.IDLE) {
      unregistered.add(object);
    }
  }

  /** Its process has such an object no longer; false where it had none of that name. */
  boolean removeUnregistered(UID object) {
    return unregistered.remove(object);
  }

  /** How many objects its process may have that are not registered any more. */
  int unregistered() {
    return unregistered.size();
  }

  /** Whether it held a turn to start, which it gives back now. */
  boolean takeLaunchPermit() {
    boolean had = hasLaunchPermit;
    hasLaunchPermit = false;
    return had;
  }

  /** How often a process was started for the group by then, this one counted. */
  long number() {
    return number;
  }

  /** Where it stands. */
  State state() {
    return state;
  }

  /** Whether it is the one of that number, and makes objects. */
  boolean isActive(long itsNumber) {
    return state == State.ACTIVE && itsNumber == number;
  }

  /** Its process; null before its launch and after its end. */
  @Nullable ProcessIdentity process() {
    return process;
  }

  /** What makes its objects; null unless it is {@link State#ACTIVE}. */
  @Nullable ActivationInstantiator instantiator() {
    return instantiator;
  }

  /** Whether a former daemon launched it. */
  boolean adopted() {
    return adopted;
  }
}
