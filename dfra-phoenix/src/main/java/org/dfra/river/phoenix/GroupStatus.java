package org.dfra.river.phoenix;

import java.io.Serializable;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * The state of one of phoenix's groups.
 *
 * @param name the daemon's name for the group, unique in its journal
 * @param state the state of its virtual machine
 * @param incarnation how many virtual machines were started for it
 * @param pid process number of its virtual machine; −1 if there is none
 * @param adopted whether this daemon found the machine running when it started
 * @param objects registered objects
 * @param unregistered unregistered objects that its virtual machine may still have
 * @param recentCrashes crashes within the window, including those of stable modules
 * @param totalCrashes crashes since this daemon started
 * @param lastCrash how it crashed the last time, or null
 * @param heldOffUntil until when it is not started because it crashed too often, or null
 * @param output the file with the output of its virtual machine
 */
public record GroupStatus(
    String name,
    State state,
    long incarnation,
    long pid,
    boolean adopted,
    int objects,
    int unregistered,
    int recentCrashes,
    int totalCrashes,
    @Nullable String lastCrash,
    @Nullable Instant heldOffUntil,
    String output)
    implements Serializable {

  /**
   * The state of a group's virtual machine.
   *
   * <pre>
   *           launch              activeGroup             inactiveGroup
   *   IDLE -----------&gt; STARTING -------------&gt; ACTIVE -----------------&gt; LEAVING
   *    ^                   |                       |                         |
   *    +---- its process has exited ---------------+-------------------------+
   * </pre>
   */
  public enum State {
    /** No process. */
    IDLE,
    /** A process was started and has not reported yet. */
    STARTING,
    /** Instantiates objects. */
    ACTIVE,
    /** Has reported that it has no object left; its process is exiting. */
    LEAVING
  }
}
