package org.dfra.river.phoenix;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationID;
import java.rmi.activation.UnknownObjectException;
import java.rmi.server.UID;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Stream;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.river.call.CallThreads;
import org.dfra.river.phoenix.ManagedGroup.ActiveInstantiator;
import org.dfra.river.phoenix.stop.EffectorStopResult;
import org.dfra.river.phoenix.stop.GroupStopResult;
import org.dfra.river.phoenix.stop.GroupStopResult.EffectorAnswer;
import org.dfra.river.phoenix.stop.StopReport;
import org.dfra.river.phoenix.stop.StopService;
import org.dfra.river.phoenix.stop.StopTargetRegistry.StopTarget;
import org.dfra.river.phoenix.stop.StoppableGroup;
import org.dfra.river.phoenix.stop.UnconfirmedGroup;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Forwards an emergency stop to the groups' virtual machines, for callers from any computer.
 *
 * <p>Threads: {@code phoenix-stop-}. Each group has at most one running stop request and one
 * waiting one, which all further callers share. A group that does not answer delays no other. It is
 * never killed for that: its process may be the one that can stop the wheels.
 */
final class StopServiceImpl implements StopService {

  private static final Logger LOG = LoggerFactory.getLogger(StopServiceImpl.class);

  /** More than the 0.9 s that a group takes at most. */
  private static final Duration PATIENCE = Duration.ofMillis(1200);

  /** Minimum interval of warnings in the log. */
  private static final Duration WARNINGS = Duration.ofSeconds(10);

  private final GroupTable registered;
  private final Duration patience;
  private final AtomicLong warned = new AtomicLong(System.nanoTime() - WARNINGS.toNanos());
  private final Executor threads = CallThreads.pool("phoenix-stop-");
  private final Map<ManagedGroup, GroupStopQueue> orders = new ConcurrentHashMap<>();

  StopServiceImpl(GroupTable registered) {
    this(registered, PATIENCE);
  }

  /**
   * @param timeout the longest wait for all groups together
   */
  StopServiceImpl(GroupTable registered, Duration timeout) {
    this.registered = registered;
    this.patience = timeout;
  }

  /** A group's answer, and the number of its effectors that did not answer. */
  private record GroupOutcome(GroupStopResult answer, int missing) {}

  @Override
  public StopReport emergencyStop(List<String> robots, @Nullable String by) {
    String requester = EmergencyStopState.requesterName(by);
    Set<String> wanted = Set.copyOf(robots);
    List<ManagedGroup> groups = List.copyOf(registered.groups());
    orders.keySet().retainAll(groups);
    long end = System.nanoTime() + patience.toNanos();
    Map<ManagedGroup, CompletableFuture<GroupOutcome>> asked = new LinkedHashMap<>();
    for (ManagedGroup group : groups) {
      if (wanted.isEmpty() || wanted.contains(group.robot())) { // may have unregistered effectors
        asked.put(
            group,
            orders
                .computeIfAbsent(group, unused -> new GroupStopQueue())
                .add(() -> stopGroup(group, requester)));
      }
    }
    note(requester, asked.size());
    List<EffectorStopResult> effectors = new ArrayList<>();
    List<UnconfirmedGroup> unconfirmed = new ArrayList<>();
    asked.forEach(
        (group, answer) -> {
          try {
            GroupOutcome in =
                answer.get(Math.max(0, end - System.nanoTime()), TimeUnit.NANOSECONDS);
            in.answer().effectors().forEach(each -> effectors.add(each.stop()));
            if (in.missing() > 0) {
              unconfirmed.add(
                  unconfirmed(
                      group,
                      in.missing()
                          + " of its effectors did not run; phoenix starts them to stop them"));
            }
          } catch (TimeoutException e) {
            unconfirmed.add(
                unconfirmed(
                    group,
                    "its process did not answer phoenix within "
                        + patience.toMillis() / 1e3
                        + " s; it stops its effectors when it continues"));
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            unconfirmed.add(unconfirmed(group, "phoenix was interrupted while it waited for it"));
          } catch (ExecutionException e) {
            LOG.debug("Group {} was not stopped.", group.name, e.getCause()); // reported
            unconfirmed.add(unconfirmed(group, "phoenix cannot reach it: " + reason(e)));
          }
        });
    unconfirmed.removeIf(each -> hasNoEffectors(each, asked.keySet()));
    List<String> known =
        groups.stream()
            .map(ManagedGroup::robot)
            .filter(each -> !each.isEmpty())
            .distinct()
            .sorted()
            .toList();
    return new StopReport(known, effectors, unconfirmed);
  }

  /** Logs a stop request. Any client may call, so the log must not grow with the calls. */
  private void note(String requester, int groups) {
    String what = "Emergency stop by {}: {} groups are ordered to stop.";
    long now = System.nanoTime();
    long before = warned.get();
    if (now - before >= WARNINGS.toNanos() && warned.compareAndSet(before, now)) {
      LOG.warn(what, requester, groups);
    } else {
      LOG.debug(what, requester, groups);
    }
  }

  private static UnconfirmedGroup unconfirmed(ManagedGroup group, String reason) {
    return new UnconfirmedGroup(group.robot(), group.plainName(), reason);
  }

  /** One line: remote exceptions repeat their causes on further lines. */
  private static String reason(ExecutionException failure) {
    String text = String.valueOf(failure.getCause());
    return text.lines().findFirst().orElse(text);
  }

  private GroupOutcome stopGroup(ManagedGroup group, String by) throws RemoteException {
    Optional<ActiveInstantiator> maker = group.active();
    GroupStopResult answer = maker.isEmpty() ? GroupStopResult.NONE : order(maker.get(), group, by);
    List<ActivatableObject> missing = missing(group, answer);
    if (!missing.isEmpty()) {
      orders
          .computeIfAbsent(group, unused -> new GroupStopQueue())
          .start(() -> startAndStop(group, missing, by));
    }
    return new GroupOutcome(answer, missing.size());
  }

  private static GroupStopResult order(ActiveInstantiator maker, ManagedGroup group, String by)
      throws RemoteException {
    if (maker.instantiator() instanceof StoppableGroup stop) {
      return stop.emergencyStop(by);
    }
    throw new RemoteException(
        "group " + group.name + " cannot be ordered to stop: its proxy lacks StoppableGroup");
  }

  /** The objects of a group that are, or may be, effectors and did not answer. */
  private List<ActivatableObject> missing(ManagedGroup group, GroupStopResult answer) {
    Set<UID> answered = new HashSet<>();
    Stream.concat(
            answer.effectors().stream().map(EffectorAnswer::object), answer.otherObjects().stream())
        .forEach(id -> uid(id).ifPresent(answered::add));
    return registered.objects(group).stream()
        .filter(StopServiceImpl::mayBeEffector)
        .filter(each -> !answered.contains(each.uid))
        .toList();
  }

  /** By UID, not by ID: a group may know phoenix at a former address. */
  private static Optional<UID> uid(ActivationID id) {
    try {
      return Optional.of(GroupTable.uid(id));
    } catch (UnknownObjectException e) {
      LOG.debug("A group answered for an object that is not phoenix's.", e);
      return Optional.empty();
    }
  }

  /** Whether a group certainly has no effector (a registrar's, for example), whatever its state. */
  private boolean hasNoEffectors(UnconfirmedGroup unconfirmed, Set<ManagedGroup> groups) {
    return groups.stream()
        .filter(group -> group.plainName().equals(unconfirmed.group()))
        .flatMap(group -> registered.objects(group).stream())
        .noneMatch(StopServiceImpl::mayBeEffector);
  }

  /** A class that phoenix does not have may be an effector. */
  private static boolean mayBeEffector(ActivatableObject object) {
    try {
      return StopTarget.class.isAssignableFrom(
          Class.forName(
              object.desc().getClassName(), false, StopServiceImpl.class.getClassLoader()));
    } catch (ClassNotFoundException | LinkageError e) {
      return true;
    }
  }

  /** Starts the effectors that do not run and stops them: then no later start makes them move. */
  private void startAndStop(ManagedGroup group, List<ActivatableObject> effectors, String by) {
    for (ActivatableObject each : effectors) {
      try {
        Object unused = each.activate(registered.activationID(each.uid), false);
      } catch (ActivationException e) { // unregistered meanwhile, or it crashes: the report has it
        LOG.debug(
            "An effector of {} cannot be started to be stopped: {}", group.name, e.toString());
      }
      stopStarted(group, by); // immediately: the next start may take long
    }
  }

  private static void stopStarted(ManagedGroup group, String by) {
    try {
      Optional<ActiveInstantiator> maker = group.active();
      if (maker.isPresent()) {
        GroupStopResult unused = order(maker.get(), group, by);
      }
    } catch (RemoteException e) {
      LOG.debug("What was started in group {} was not stopped: {}", group.name, e.toString());
    }
  }

  /** Calls a group to stop. */
  private interface StopCall {
    GroupOutcome ask() throws RemoteException;
  }

  /** The stop requests to one group: one running, one waiting. */
  private final class GroupStopQueue {

    @GuardedBy("this")
    private CompletableFuture<GroupOutcome> current =
        CompletableFuture.completedFuture(new GroupOutcome(GroupStopResult.NONE, 0));

    @GuardedBy("this")
    private @Nullable CompletableFuture<GroupOutcome> waiting;

    @GuardedBy("this")
    private boolean starting;

    /** Adds a request, or shares the waiting one. */
    synchronized CompletableFuture<GroupOutcome> add(StopCall asking) {
      @Nullable CompletableFuture<GroupOutcome> shared = waiting;
      if (shared != null) {
        return shared;
      }
      CompletableFuture<GroupOutcome> added = new CompletableFuture<>();
      waiting = added;
      CompletableFuture<GroupOutcome> unused =
          current.whenComplete((answer, failure) -> begin(added, asking));
      return added;
    }

    private void begin(CompletableFuture<GroupOutcome> order, StopCall asking) {
      synchronized (this) {
        waiting = null;
        current = order;
      }
      run(
          () -> {
            try {
              order.complete(asking.ask());
            } catch (RemoteException | RuntimeException | Error e) { // the callers report it
              order.completeExceptionally(e);
            }
          });
    }

    /** Starts the objects that do not run, unless this is in progress. */
    void start(Runnable task) {
      synchronized (this) {
        if (starting) {
          return;
        }
        starting = true;
      }
      run(
          () -> {
            try {
              task.run();
            } finally {
              synchronized (this) {
                starting = false;
              }
            }
          });
    }

    /** Uses the caller's thread if no further thread can be created. */
    private void run(Runnable task) {
      try {
        threads.execute(task);
      } catch (OutOfMemoryError e) {
        task.run();
      }
    }
  }
}
