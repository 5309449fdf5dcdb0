package org.dfra.river.phoenix;

import java.io.Serializable;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * What phoenix knows of one of its groups.
 *
 * @param name the daemon's name for the group, unique in its journal
 * @param state where its virtual machine stands
 * @param incarnation how often a virtual machine was started for it
 * @param pid process number of its virtual machine, or −1 where there is none
 * @param adopted whether this daemon found the machine running when it started
 * @param objects registered objects
 * @param unregistered objects that were unregistered, but that its virtual machine may still have
 * @param recentCrashes crashes within the window, those of modules that had worked included
 * @param totalCrashes crashes since this daemon started
 * @param lastCrash how it ended the last time, or null
 * @param heldOffUntil until when it is not started because it crashed too often, or null
 * @param output the file with what its virtual machine prints
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
   * Where a group's virtual machine stands.
   *
   * <pre>
   *           launch              activeGroup             inactiveGroup
   *   IDLE -----------&gt; STARTING -------------&gt; ACTIVE -----------------&gt; LEAVING
   *    ^                   |                       |                         |
   *    +---- its process is proven dead -----------+-------------------------+
   * </pre>
   */
  public enum State {
    /** No process. */
    IDLE,
    /** A process was started; awaits its first report. */
    STARTING,
    /** Makes objects. */
    ACTIVE,
    /** Has no object left and said so; awaits the end of its process. */
    LEAVING
  }
}
