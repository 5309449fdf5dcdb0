package org.dfra.recruit.agent;

import java.rmi.RemoteException;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.core.chain.Errands;
import org.dfra.core.module.ModuleContext;
import org.dfra.directory.Condition;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.NotReadyException;
import org.dfra.persona.RecruitmentAttributes;
import org.dfra.recruit.message.Letter;
import org.dfra.recruit.transport.Transport;
import org.slf4j.Logger;

/**
 * Brings letters to the agents that the directory knows, by one to each. A robot has a thread of
 * its own here while letters wait for it, so one that does not answer holds up its own letters
 * only. At most {@value #WAITING} letters wait for a robot; further ones are lost. So is a letter
 * that cannot be brought.
 */
public final class DirectoryTransport implements Transport, AutoCloseable {

  private static final int WAITING = 32;

  /** What goes to one robot, while there is anything. */
  private static final class Route {
    final Errands errands;
    int waiting; // changed within routes.compute only

    Route(Errands errands) {
      this.errands = errands;
    }
  }

  private final ModuleContext context;
  private final Logger log;
  private final Map<String, Route> routes = new ConcurrentHashMap<>();
  private volatile boolean isClosed;

  /**
   * @param context of the agent's module, which does not write to its own robot
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
  public List<String> capable(String percept) {
    return others(
            ModuleQuery.of(RecruitmentAgent.class)
                .where(RecruitmentAttributes.class, "percepts", Condition.contains(percept)))
        .stream()
        .map(ModuleListing::robot)
        .distinct()
        .toList();
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
  public void send(String robot, Letter letter) {
    if (isClosed) {
      return;
    }
    AtomicInteger place = new AtomicInteger();
    Route route =
        routes.compute(
            robot,
            (name, known) -> {
              Route to = known != null ? known : route(name);
              to.waiting++;
              place.set(to.waiting);
              return to;
            });
    if (place.get() > WAITING) {
      brought(robot);
      log.warn("{}: {} does not take letters; {} is lost", context.path(), robot, letter.message());
      return;
    }
    try {
      route.errands.now(() -> deliverAndCount(robot, letter));
    } catch (OutOfMemoryError e) { // no room for one more thread; the next letter may find one
      brought(robot);
      log.warn("{}: a letter to {} is lost: {}", context.path(), robot, e.toString());
    }
  }

  private Route route(String robot) {
    return new Route(
        new Errands("dfra-letters " + context.path() + " to " + robot, context.robotTime()));
  }

  /** One letter waits no more. With the last one, the robot's thread ends. */
  private void brought(String robot) {
    routes.computeIfPresent(
        robot,
        (name, route) -> {
          route.waiting--;
          if (route.waiting > 0) {
            return route;
          }
          route.errands.close();
          return null;
        });
  }

  private void deliverAndCount(String robot, Letter letter) {
    try {
      deliver(robot, letter);
    } finally {
      brought(robot);
    }
  }

  private void deliver(String robot, Letter letter) {
    List<ModuleListing<RecruitmentAgent>> found =
        context.directory().find(ModuleQuery.of(RecruitmentAgent.class).robot(robot));
    if (found.isEmpty()) {
      log.debug("{}: {} is not there any more", context.path(), robot);
      return;
    }
    try {
      found.get(0).module().receive(letter);
    } catch (RemoteException | NotReadyException e) {
      log.debug("{}: a letter to {} is lost: {}", context.path(), robot, e.toString());
    } catch (IllegalArgumentException e) { // one of another version; a lost letter like any other
      log.warn("{}: {} does not understand a letter: {}", context.path(), robot, e.toString());
    }
  }

  @Override
  public void broadcast(String percept, Letter letter) {
    capable(percept).forEach(robot -> send(robot, letter));
  }

  @Override
  public void close() {
    isClosed = true;
    routes.values().forEach(route -> route.errands.close());
  }
}
