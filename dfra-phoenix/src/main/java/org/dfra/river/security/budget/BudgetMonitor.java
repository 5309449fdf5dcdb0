package org.dfra.river.security.budget;

import java.io.Serializable;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.util.List;
import org.dfra.core.budget.BudgetUse;
import org.dfra.core.budget.ListenerPriority;
import org.dfra.module.Idempotent;

/** What callers and modules have used of a process, as far as budgets are declared. */
public interface BudgetMonitor extends Remote {

  /**
   * What was used.
   *
   * @param accounts by budget and owner
   * @param radio of the computer; all zero if no rate is declared
   */
  record Report(List<BudgetUse> accounts, RadioUse radio) implements Serializable {

    /** Copies the list. */
    public Report {
      accounts = List.copyOf(accounts);
    }
  }

  /**
   * How much the network of the robot's computer is used by all its processes.
   *
   * @param rate measured, in bytes per second, both directions together
   * @param max declared, in bytes per second; 0 if nothing is
   * @param oneIn of the readings for listeners of each {@link ListenerPriority}, every n-th is sent
   * @param thinned readings of this process that were not sent, since its start
   */
  record RadioUse(double rate, double max, List<Integer> oneIn, long thinned)
      implements Serializable {

    /** Copies the list. */
    public RadioUse {
      oneIn = List.copyOf(oneIn);
    }
  }

  /** What was used so far. */
  @Idempotent
  Report budgets() throws RemoteException;
}
