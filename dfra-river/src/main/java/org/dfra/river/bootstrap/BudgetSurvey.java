package org.dfra.river.bootstrap;

import java.io.IOException;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.activation.ActivationException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.dfra.river.bootstrap.PhoenixInventory.RegisteredService;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.phoenix.PhoenixAdmin;
import org.dfra.river.security.budget.BudgetMonitor;
import org.dfra.river.security.budget.ProcessBudgets;
import org.jspecify.annotations.Nullable;

/**
 * What phoenix and the running processes of a computer's robots report about their budgets.
 *
 * @param reports by group, as {@code robot.group}; and {@value #PHOENIX}
 * @param silent groups without an answer, with the reason, in words
 */
public record BudgetSurvey(Map<String, BudgetMonitor.Report> reports, List<String> silent) {

  /** The name of phoenix, which no group has. */
  public static final String PHOENIX = "phoenix";

  /**
   * Asks the processes.
   *
   * @param robots names of the robots; all if empty
   * @throws IOException if phoenix does not answer
   * @throws ActivationException if a group was unregistered meanwhile
   */
  public static BudgetSurvey of(PhoenixProcess phoenix, Set<String> robots)
      throws IOException, ActivationException {
    PhoenixAdmin admin = phoenix.admin();
    Map<String, BudgetMonitor.Report> reports = new TreeMap<>();
    Set<String> groups = new TreeSet<>();
    Map<String, String> faults = new TreeMap<>();
    groups.add(PHOENIX);
    try {
      PeerAddress itself = new PeerAddress(phoenix.host(), phoenix.port());
      reports.put(PHOENIX, ProcessBudgets.at(itself).budgets());
    } catch (IOException e) {
      faults.put(PHOENIX, String.valueOf(e.getMessage()));
    }
    for (RegisteredService each : PhoenixInventory.services(phoenix)) {
      boolean isAsked = robots.isEmpty() || robots.contains(each.robot());
      if (!isAsked || reports.containsKey(each.group())) {
        continue;
      }
      groups.add(each.group());
      try {
        @Nullable PeerAddress process = address(admin, each);
        if (process != null) {
          reports.put(each.group(), ProcessBudgets.at(process).budgets());
        }
      } catch (IOException | ClassNotFoundException | ActivationException e) {
        faults.put(each.group(), String.valueOf(e.getMessage()));
      }
    }
    List<String> silent = new ArrayList<>();
    for (String each : groups) {
      if (!reports.containsKey(each)) {
        silent.add(each + ": " + faults.getOrDefault(each, "nothing of it runs"));
      }
    }
    return new BudgetSurvey(reports, silent);
  }

  /** Where the process of a service can be called; null if the service does not run. */
  private static @Nullable PeerAddress address(PhoenixAdmin admin, RegisteredService service)
      throws IOException, ClassNotFoundException, ActivationException {
    @Nullable MarshalledObject<? extends Remote> proxy = admin.activeProxy(service.id());
    return proxy == null ? null : PeerAddress.of(proxy.get());
  }
}
