package org.dfra.river.bootstrap;

/**
 * One step of a robot's bring-up, for one of its services or groups.
 *
 * @param name {@code robot/module}, {@code robot/registrar}, or {@code robot.group} of a group
 * @param group name of the service group
 * @param kind the kind of step
 * @param detail details in words, such as the changes; may be empty
 */
public record BringUpStep(String name, String group, Kind kind, String detail) {

  /** The kinds of steps. */
  public enum Kind {
    /** The service did not run and was started. */
    STARTED,
    /** The service ran as described and was not touched. */
    UNCHANGED,
    /** The service ran with another description and was restarted. */
    RESTARTED,
    /** The service ran in another group; it was ended there and started here. */
    MOVED,
    /** The service is no longer described; it was ended and unregistered. */
    ENDED,
    /**
     * The group's process keeps running with the settings of its start, though its description
     * changed.
     */
    GROUP_STALE,
    /** The group's process was ended, so that a new one starts as described. */
    GROUP_RESTARTED,
    /**
     * A process was ended because it still had services that are no longer registered with phoenix;
     * the detail is their number.
     */
    PROCESS_ENDED,
    /** The group is no longer described; it was ended and unregistered. */
    GROUP_ENDED
  }

  /** Receives the progress of a bring-up. */
  public interface Listener {
    /** A step is complete. */
    void onStep(BringUpStep step);
  }
}
