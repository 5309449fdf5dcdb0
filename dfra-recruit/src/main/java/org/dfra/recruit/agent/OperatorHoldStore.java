package org.dfra.recruit.agent;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.dfra.core.module.ModuleContext;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * Persistent state of an {@link OperatorHold}: the stops that an operator has handled, the last
 * reason of a hold, and the robot's modules. Guarded by the lock of its hold, which also decides
 * when to write it.
 */
final class OperatorHoldStore {

  private static final String DOCUMENT = "hold";

  /** Prefix of the last reason in the document. */
  private static final String LAST = "=";

  /** Used in the document in place of a module's path. */
  private static final String TRIP = "-";

  /** Prefix of a behaviour or an effector of the robot in the document. */
  private static final String HAS = "+";

  /**
   * The reason of a hold.
   *
   * @param path of the module
   * @param why reason, as a clause
   */
  record HoldReason(String path, String why) {}

  private final ModuleContext context;
  private final Logger log;

  /** Start of the last stop that an operator has handled, by the path of the module. */
  private final Map<String, String> ended = new TreeMap<>();

  private @Nullable HoldReason last;
  private @Nullable String unknown;
  private final Set<String> modules = new TreeSet<>();

  OperatorHoldStore(ModuleContext context, Logger log) {
    this.context = context;
    this.log = log;
  }

  /** Reads the document of an earlier process. A failure sets {@link #unknown()}. */
  void load() {
    try {
      String text =
          new String(context.state().read(DOCUMENT).orElse(new byte[0]), StandardCharsets.UTF_8);
      text.lines()
          .map(line -> line.split(" ", 2))
          .filter(line -> line.length == 2)
          .forEach(this::take);
    } catch (IOException e) {
      unknown =
          "the stored hold cannot be read, so it is unknown whether the robot was stopped: "
              + e.getMessage();
      log.warn("{}: {}", context.path(), unknown);
    }
  }

  private void take(String[] line) {
    if (line[0].equals(TRIP)) {
      unknown = line[1];
    } else if (line[0].equals(LAST)) {
      String[] reason = line[1].split(" ", 2);
      last = new HoldReason(reason[0], reason[reason.length - 1]);
    } else if (line[0].equals(HAS)) {
      modules.add(line[1]);
    } else {
      ended.put(line[0], line[1]);
    }
  }

  /** Writes it for the next process. A failure is logged. */
  void save() {
    try {
      context.state().write(DOCUMENT, text().getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      log.warn(
          "{}: the hold cannot be stored, so it is lost after a restart: {}",
          context.path(),
          e.toString());
    }
  }

  /** The document that {@link #save} writes now. */
  String text() {
    StringBuilder text = new StringBuilder();
    ended.forEach((path, since) -> text.append(path).append(' ').append(since).append('\n'));
    if (unknown != null) {
      text.append(TRIP).append(' ').append(unknown.replace('\n', ' ')).append('\n');
    }
    @Nullable HoldReason reason = last;
    if (reason != null) {
      text.append(LAST + " " + reason.path() + " " + reason.why().replace('\n', ' ') + "\n");
    }
    modules.forEach(path -> text.append(HAS).append(' ').append(path).append('\n'));
    return text.toString();
  }

  /** Start of the last stop of a module that an operator has handled; null for none. */
  @Nullable String endedStop(String path) {
    return ended.get(path);
  }

  /** Records that an operator has handled a module's stop. */
  void setEndedStop(String path, String since) {
    ended.put(path, since);
  }

  /** Records the stop of a module when it was first seen; false if one is recorded already. */
  boolean noteFirst(String path, String since) {
    return ended.putIfAbsent(path, since) == null;
  }

  /** The last reason of a hold, until its module is found and reports otherwise. */
  @Nullable HoldReason last() {
    return last;
  }

  void last(@Nullable HoldReason reason) {
    last = reason;
  }

  /** The unknown end of the last trip, as a clause; null where it is known. */
  @Nullable String unknown() {
    return unknown;
  }

  void unknown(@Nullable String why) {
    unknown = why;
  }

  /** The known behaviours and effectors of the robot, by path. */
  Set<String> modules() {
    return Collections.unmodifiableSet(modules);
  }

  /** Adds these modules; returns whether one of them was new. */
  boolean add(Set<String> paths) {
    return modules.addAll(paths);
  }

  /** Sets the robot's modules to exactly these. */
  void retain(Set<String> paths) {
    modules.retainAll(paths);
  }
}
