package org.dfra.river.loading;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Publishes a group's classes for clients that lack them. It annotates classes with the digests of
 * the robot's jars at the group's start, and in the registrar's group it serves the jars.
 *
 * <p>An error here does not keep a group from starting, since a robot also works without clients.
 * Errors are in the group's log, and a taken port is retried until it is free.
 */
public final class GroupCodebasePublisher {

  private static final Logger LOG = LoggerFactory.getLogger(GroupCodebasePublisher.class);

  private static final long AGAIN_SECONDS = 5;

  private final RobotCodebase classes;
  private final JarStore kept;
  private final Map<String, Path> readable = new LinkedHashMap<>();

  private GroupCodebasePublisher(RobotCodebase classes) {
    this.classes = classes;
    this.kept = new JarStore(classes.storeFolder());
  }

  /** Applies this virtual machine's settings; does nothing if its robot serves no classes. */
  public static void begin() {
    RobotCodebase.fromProperties(System.getProperties())
        .map(GroupCodebasePublisher::new)
        .ifPresent(
            group -> {
              group.annotate();
              if (RobotCodebase.serves(System.getProperties())) {
                group.serve();
              }
            });
  }

  private void annotate() {
    Map<String, String> byClass = new HashMap<>();
    for (List<Path> kind : classes.moduleCodebases()) {
      List<RobotCodebase.Jar> jars = read(kind);
      String codebase = classes.annotation(jars);
      jars.forEach(jar -> jar.classes().forEach(name -> byClass.putIfAbsent(name, codebase)));
    }
    List<RobotCodebase.Jar> jars = read(classes.commonJars());
    TrustedCode.annotate(jars.isEmpty() ? null : classes.annotation(jars), byClass);
  }

  /** The jars of a codebase, or none of them if one cannot be read. */
  private List<RobotCodebase.Jar> read(List<Path> codebase) {
    List<RobotCodebase.Jar> jars = new ArrayList<>();
    try {
      for (Path file : codebase) {
        jars.add(RobotCodebase.read(file));
      }
    } catch (IOException e) {
      LOG.error("Clients cannot download {}: {}.", codebase, e.getMessage());
      return List.of();
    }
    for (int i = 0; i < jars.size(); i++) {
      readable.put(jars.get(i).name(), codebase.get(i));
      keep(jars.get(i));
    }
    return jars;
  }

  private void keep(RobotCodebase.Jar jar) {
    try {
      kept.put(jar.bytes(), jar.digest());
    } catch (IOException e) {
      LOG.warn("{} can be downloaded only until it is rebuilt: {}.", jar.name(), e.getMessage());
    }
  }

  private void serve() {
    if (readable.isEmpty()) {
      return;
    }
    ClassServer server = new ClassServer(classes.host(), classes.port(), readable, kept);
    @Nullable String fault = start(server);
    if (fault == null) {
      return;
    }
    LOG.warn("{}; trying again every {} s.", fault, AGAIN_SECONDS);
    ScheduledExecutorService later =
        Executors.newSingleThreadScheduledExecutor(
            task -> {
              Thread thread = new Thread(task, "class server waits");
              thread.setDaemon(true);
              return thread;
            });
    later.scheduleWithFixedDelay(
        () -> {
          if (start(server) == null) {
            later.shutdown();
          }
        },
        AGAIN_SECONDS,
        AGAIN_SECONDS,
        TimeUnit.SECONDS);
  }

  /** Starts the class server, whose threads keep it reachable; returns the error, or null. */
  private static @Nullable String start(ClassServer server) {
    try {
      server.start();
      return null;
    } catch (IOException e) {
      return String.valueOf(e.getMessage());
    }
  }
}
