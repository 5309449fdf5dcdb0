package org.dfra.river.phoenix;

import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationInstantiator;
import java.rmi.server.UID;
import java.util.HashSet;
import java.util.Set;
import org.dfra.river.phoenix.GroupStatus.State;
import org.jspecify.annotations.Nullable;

/**
 * One run of a group's process. Its state follows the arrows of {@link State}. It leaves the states
 * of a process only after that process has certainly exited. It does not return to them: the next
 * launch is another incarnation. Confined to the group's lock, except its number and instantiator.
 */
final class GroupIncarnation {

  private final long number;
  private State state;
  private @Nullable ProcessIdentity process;

  /** Not null while it is ACTIVE. Volatile, since an emergency stop reads it without the lock. */
  private volatile @Nullable ActivationInstantiator instantiator;

  private boolean adopted;
  private boolean hasLaunchPermit; // whether it holds a launch permit
  private final Set<UID> unregistered = new HashSet<>(); // while its process may have had them

  private GroupIncarnation(long number, State state) {
    this.number = number;
    this.state = state;
  }

  /** An incarnation that has ended, or 0 if there was none yet. */
  static GroupIncarnation past(long number) {
    return new GroupIncarnation(number, State.IDLE);
  }

  /** The next incarnation: its process will be launched next. */
  GroupIncarnation next() {
    return new GroupIncarnation(number + 1, State.STARTING);
  }

  /**
   * Refuses a process that was launched for an incarnation which does not await it any more.
   *
   * @param group the group's name, for messages
   * @throws ActivationException if this is another incarnation, has ended, or has a process
   */
  void requireUnlaunched(String group, long itsNumber) throws ActivationException {
    if (itsNumber != number || state == State.IDLE || process != null) {
      throw new ActivationException(
          "the process of incarnation "
              + itsNumber
              + " of group "
              + group
              + " is not awaited any more: phoenix knows incarnation "
              + number
              + " as "
              + state);
    }
  }

  /** Records that its process was launched, with a launch permit. */
  void launched(ProcessIdentity started) {
    process = started;
    hasLaunchPermit = true;
  }

  /**
   * Adopts a running process that a former daemon launched.
   *
   * @param known the instantiator that it reported, if it did
   * @param leaving whether it announced its exit
   */
  void adopt(ProcessIdentity found, @Nullable ActivationInstantiator known, boolean leaving) {
    process = found;
    adopted = true;
    instantiator = leaving ? null : known;
    state = leaving ? State.LEAVING : known == null ? State.STARTING : State.ACTIVE;
  }

  /**
   * Whether this reporter made the same report before; false if it may report now.
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
              + " is refused: phoenix knows incarnation "
              + number
              + " as "
              + state);
    }
    if (state == State.ACTIVE && !reporter.equals(instantiator)) {
      throw new ActivationException("group " + group + " already has an instantiator");
    }
    return state == State.ACTIVE;
  }

  /** Records that its process instantiates objects. */
  void reported(ActivationInstantiator reporter) {
    instantiator = reporter;
    state = State.ACTIVE;
  }

  /** Records that its process instantiates no more objects, and is exiting. */
  void setLeaving() {
    instantiator = null;
    state = State.LEAVING;
  }

  /** Records that its process has exited, or was never launched. */
  void ended() {
    state = State.IDLE;
    process = null;
    instantiator = null;
    adopted = false;
    unregistered.clear();
  }

  /** Records that an object was unregistered that its process may have. */
  void addUnregistered(UID object) {
    if (state != State.IDLE) {
      unregistered.add(object);
    }
  }

  /** Records that its process has dropped an unregistered object; false if it had no such one. */
  boolean removeUnregistered(UID object) {
    return unregistered.remove(object);
  }

  /** How many unregistered objects its process may have. */
  int unregistered() {
    return unregistered.size();
  }

  /** Whether it held a launch permit, which the caller must now release. */
  boolean takeLaunchPermit() {
    boolean had = hasLaunchPermit;
    hasLaunchPermit = false;
    return had;
  }

  /** How many processes had been started for the group, this one included. */
  long number() {
    return number;
  }

  /** Its state. */
  State state() {
    return state;
  }

  /** Whether it has that number and instantiates objects. */
  boolean isActive(long itsNumber) {
    return state == State.ACTIVE && itsNumber == number;
  }

  /** Its process; null before its launch and after its exit. */
  @Nullable ProcessIdentity process() {
    return process;
  }

  /** Its instantiator; null unless it is {@link State#ACTIVE}. */
  @Nullable ActivationInstantiator instantiator() {
    return instantiator;
  }

  /** Whether a former daemon launched it. */
  boolean adopted() {
    return adopted;
  }
}
