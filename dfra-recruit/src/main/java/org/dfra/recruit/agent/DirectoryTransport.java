package org.dfra.recruit.agent;

import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.core.chain.DelayedTaskExecutor;
import org.dfra.core.module.ModuleContext;
import org.dfra.directory.Condition;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.NotReadyException;
import org.dfra.persona.RecruitmentAttributes;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.transport.Transport;
import org.slf4j.Logger;

/**
 * Delivers messages to the agents in the directory, one transmission to each. Each robot has its
 * own thread while messages wait for it, so an unresponsive robot delays only its own messages. At
 * most {@value #WAITING} messages wait for a robot; further ones are lost. So is a message that
 * cannot be delivered.
 *
 * <p>A message identifies its receiver only by the robot's name. If several robots have that name,
 * even if one of them is out of reach, nothing is sent to it: the log reports this once.
 */
public final class DirectoryTransport implements Transport, AutoCloseable {

  private static final int WAITING = 32;

  /** The outbox of one robot, while it is not empty. */
  private static final class Outbox {
    final DelayedTaskExecutor taskExecutor;
    int waiting; // changed within routes.compute only

    Outbox(DelayedTaskExecutor taskExecutor) {
      this.taskExecutor = taskExecutor;
    }
  }

  private final ModuleContext context;
  private final Logger log;
  private final Map<String, Outbox> routes = new ConcurrentHashMap<>();
  private final Map<String, String> warned = new ConcurrentHashMap<>(); // by robot
  private volatile boolean isClosed;

  /**
   * @param context of the agent's module, which does not send to its own robot
   */
  public DirectoryTransport(ModuleContext context, Logger log) {
    this.context = context;
    this.log = log;
  }

  private List<ModuleListing<RecruitmentAgent>> others(ModuleQuery<RecruitmentAgent> query) {
    return context.directory().find(query).stream()
        .filter(listing -> !listing.robot().equals(context.robot()))
        .toList();
  }

  @Override
  public List<String> capableRobots(String percept) {
    Map<String, List<ModuleListing<RecruitmentAgent>>> agents = byRobot();
    return observing(percept).stream()
        .filter(robot -> hosts(agents.getOrDefault(robot, List.of())).size() <= 1)
        .toList();
  }

  @Override
  public List<String> ambiguousNames(String percept) {
    Map<String, List<ModuleListing<RecruitmentAgent>>> agents = byRobot();
    return observing(percept).stream()
        .flatMap(robot -> ambiguity(robot, agents.getOrDefault(robot, List.of())).stream())
        .toList();
  }

  private Map<String, List<ModuleListing<RecruitmentAgent>>> byRobot() {
    return others(ModuleQuery.of(RecruitmentAgent.class)).stream()
        .collect(Collectors.groupingBy(ModuleListing::robot));
  }

  /** Names of the other robots that declare the percept. */
  private List<String> observing(String percept) {
    return others(
            ModuleQuery.of(RecruitmentAgent.class)
                .where(RecruitmentAttributes.class, "percepts", Condition.contains(percept)))
        .stream()
        .map(ModuleListing::robot)
        .distinct()
        .toList();
  }

  /**
   * The hosts of the agents' robots, one entry per robot: two agents with the same host and module
   * name belong to two robots, too.
   */
  private static List<String> hosts(List<ModuleListing<RecruitmentAgent>> agents) {
    Map<String, Integer> robots = new TreeMap<>(); // number per host
    Map<String, Integer> modules = new HashMap<>();
    for (ModuleListing<RecruitmentAgent> each : agents) {
      int sameModule = modules.merge(each.host() + "/" + each.name(), 1, Integer::sum);
      robots.merge(each.host(), sameModule, Math::max);
    }
    List<String> hosts = new ArrayList<>();
    robots.forEach((host, count) -> hosts.addAll(Collections.nCopies(count, host)));
    return hosts;
  }

  /** A clause that reports several robots of this name; empty where there is only one. */
  private static Optional<String> ambiguity(
      String robot, List<ModuleListing<RecruitmentAgent>> agents) {
    List<String> hosts = hosts(agents);
    return hosts.size() <= 1
        ? Optional.empty()
        : Optional.of(
            hosts.size() + " robots are named " + robot + ", on " + String.join(" and ", hosts));
  }

  @Override
  public List<String> percepts() {
    return others(ModuleQuery.of(RecruitmentAgent.class)).stream()
        .flatMap(listing -> listing.attributes(RecruitmentAttributes.class).stream())
        .flatMap(attributes -> attributes.percepts().stream())
        .distinct()
        .sorted()
        .toList();
  }

  @Override
  public void send(String robot, MessageEnvelope envelope) {
    if (isClosed) {
      return;
    }
    AtomicInteger place = new AtomicInteger();
    Outbox route =
        routes.compute(
            robot,
            (name, known) -> {
              Outbox to = known != null ? known : route(name);
              to.waiting++;
              place.set(to.waiting);
              return to;
            });
    if (place.get() > WAITING) {
      brought(robot);
      log.warn(
          "{}: {} does not accept messages of agents; {} is lost",
          context.path(),
          robot,
          envelope.message());
      return;
    }
    try {
      route.taskExecutor.execute(() -> deliverAndCount(robot, envelope));
    } catch (OutOfMemoryError e) { // no thread could be created; the next message retries
      brought(robot);
      log.warn("{}: a message to {} is lost: {}", context.path(), robot, e.toString());
    }
  }

  private Outbox route(String robot) {
    return new Outbox(
        new DelayedTaskExecutor(
            "dfra-messages " + context.path() + " to " + robot, context.robotTime()));
  }

  /** Removes one message. With the last one, the robot's thread ends. */
  private void brought(String robot) {
    routes.computeIfPresent(
        robot,
        (name, route) -> {
          route.waiting--;
          if (route.waiting > 0) {
            return route;
          }
          route.taskExecutor.close();
          return null;
        });
  }

  private void deliverAndCount(String robot, MessageEnvelope envelope) {
    try {
      deliver(robot, envelope);
    } finally {
      brought(robot);
    }
  }

  private void deliver(String robot, MessageEnvelope envelope) {
    List<ModuleListing<RecruitmentAgent>> found =
        context.directory().find(ModuleQuery.of(RecruitmentAgent.class).robot(robot));
    Optional<String> ambiguity = ambiguity(robot, found);
    if (ambiguity.isPresent()) {
      if (!ambiguity.get().equals(warned.put(robot, ambiguity.get()))) {
        log.warn(
            "{}: no message is sent to {}: {}; give each robot a different name in its XML",
            context.path(),
            robot,
            ambiguity.get());
      }
      return;
    }
    warned.remove(robot);
    if (found.isEmpty()) {
      log.debug("{}: {} is no longer registered", context.path(), robot);
      return;
    }
    try {
      found.get(0).module().receive(envelope);
    } catch (RemoteException | NotReadyException e) {
      log.debug("{}: a message to {} is lost: {}", context.path(), robot, e.toString());
    } catch (IllegalArgumentException e) { // another version; a lost message like any other
      log.warn("{}: {} rejected a message: {}", context.path(), robot, e.toString());
    }
  }

  @Override
  public void broadcast(String percept, MessageEnvelope envelope) {
    capableRobots(percept).forEach(robot -> send(robot, envelope));
  }

  @Override
  public void close() {
    isClosed = true;
    routes.values().forEach(route -> route.taskExecutor.close());
  }
}
