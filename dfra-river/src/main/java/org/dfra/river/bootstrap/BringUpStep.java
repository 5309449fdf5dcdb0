package org.dfra.river.bootstrap;

/**
 * What the bringing up of a robot has done to one of its services or groups.
 *
 * @param name {@code robot/module}, {@code robot/registrar}, or {@code robot.group} of a group
 * @param group name of the service group
 * @param kind what was done
 * @param detail more of it in words, such as what was changed; may be empty
 */
public record BringUpStep(String name, String group, Kind kind, String detail) {

  /** What may be done. */
  public enum Kind {
    /** It did not run, and was started. */
    STARTED,
    /** It ran as it is described, and was left alone. */
    UNCHANGED,
    /** It ran otherwise than it is described, was ended and started anew. */
    RESTARTED,
    /** It ran in another group, was ended there and started here. */
    MOVED,
    /** The description does not name it any more: it was ended and unregistered. */
    ENDED,
    /** A group whose process works on as it was started, though it is described otherwise. */
    GROUP_STALE,
    /** A group whose process was ended, so that another one is started as described. */
    GROUP_RESTARTED,
    /**
     * A process that was ended because it still had services that phoenix had forgotten; the detail
     * is how many.
     */
    PROCESS_ENDED,
    /** A group that the description does not name any more: it was ended and unregistered. */
    GROUP_ENDED
  }

  /** Where it has got to. */
  public interface Listener {
    /** Something was done. */
    void onStep(BringUpStep step);
  }
}
