package org.dfra.benchmarks.call;

import java.util.List;

/** On which cores client and server run, and whether these sleep between the calls. */
public enum CallCondition {

  /** Both on one core: a call needs no other core, and the core does not sleep during it. */
  ONE_CORE("one core", "client and server on the same core") {
    @Override
    CoreAssignment assign(Cores cores) throws ConditionUnavailableException {
      int core = cores.pinned(1).get(0);
      return new CoreAssignment(core, core);
    }
  },

  /** A core each, which never sleeps. */
  AWAKE_CORES(
      "awake cores",
      "client and server on a core each; a busy loop of the lowest priority keeps each core from"
          + " sleeping") {
    @Override
    CoreAssignment assign(Cores cores) throws ConditionUnavailableException {
      CoreAssignment idle = IDLE_CORES.assign(cores);
      return new CoreAssignment(idle.client(), idle.server(), cores.commandOfLowestPriority());
    }
  },

  /** A core each, which sleeps while it waits for the other one. */
  IDLE_CORES("idle cores", "client and server on a core each, and nothing else there") {
    @Override
    CoreAssignment assign(Cores cores) throws ConditionUnavailableException {
      List<Integer> two = cores.pinned(2);
      return new CoreAssignment(two.get(0), two.get(1));
    }
  },

  /** As the kernel likes it: measured only where processes cannot be pinned. */
  NOT_PINNED("not pinned", "the kernel chooses the cores of client and server") {
    @Override
    CoreAssignment assign(Cores cores) throws ConditionUnavailableException {
      if (cores.canPin()) {
        throw new ConditionUnavailableException("a computer that cannot pin processes to cores");
      }
      return new CoreAssignment(-1, -1);
    }
  };

  private final String label;
  private final String description;

  CallCondition(String label, String description) {
    this.label = label;
    this.description = description;
  }

  /**
   * Chooses the cores.
   *
   * @param cores of this computer
   * @throws ConditionUnavailableException if this computer cannot have the condition
   */
  abstract CoreAssignment assign(Cores cores) throws ConditionUnavailableException;

  /** Its name in tables and records. */
  public String label() {
    return label;
  }

  /** What it is, without a full stop. */
  public String description() {
    return description;
  }

  /** A computer cannot have a condition. */
  static final class ConditionUnavailableException extends Exception {
    private static final long serialVersionUID = 1;

    private final String need;

    /**
     * @param need what the condition needs
     */
    ConditionUnavailableException(String need) {
      super("the condition needs " + need);
      this.need = need;
    }

    /** What the condition needs. */
    String need() {
      return need;
    }
  }
}
