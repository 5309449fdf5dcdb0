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
 * What of a {@link OperatorHold} outlives its agent's process: the stops that a person has dealt
 * with, what held the robot last, and which modules it has. Guarded by the lock of its hold, which
 * also decides when it is written.
 */
final class OperatorHoldStore {

  private static final String DOCUMENT = "hold";

  /** Before what held it last, in the document. */
  private static final String LAST = "=";

  /** In the document it stands where others have a module's path. */
  private static final String TRIP = "-";

  /** Before a behaviour or an effector that the robot has, in the document. */
  private static final String HAS = "+";

  /**
   * What holds the robot.
   *
   * @param path of the module
   * @param why as a clause
   */
  record HoldReason(String path, String why) {}

  private final ModuleContext context;
  private final Logger log;

  /** Since when the last stop was that a person has dealt with, by the path of the module. */
  private final Map<String, String> ended = new TreeMap<>();

  private @Nullable HoldReason last;
  private @Nullable String unknown;
  private final Set<String> modules = new TreeSet<>();

  OperatorHoldStore(ModuleContext context, Logger log) {
    this.context = context;
    this.log = log;
  }

  /** Reads what an earlier process has written. Where it cannot, that is {@link #unknown()}. */
  void load() {
    try {
      String text =
          new String(context.state().read(DOCUMENT).orElse(new byte[0]), StandardCharsets.UTF_8);
      text.lines()
          .map(line -> line.split(" ", 2))
          .filter(line -> line.length == 2)
          .forEach(this::take);
    } catch (IOException e) {
      unknown = "it cannot read whether somebody stopped it: " + e.getMessage();
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
          "{}: its next process would not know how it is held: {}", context.path(), e.toString());
    }
  }

  /** The document, as {@link #save} writes it now. */
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

  /** Since when the last stop of a module was that a person has dealt with; null for none. */
  @Nullable String endedStop(String path) {
    return ended.get(path);
  }

  /** A person has dealt with a module's stop. */
  void setEndedStop(String path, String since) {
    ended.put(path, since);
  }

  /** Notes the stop that a module had when it was first seen; false if one is noted already. */
  boolean noteFirst(String path, String since) {
    return ended.putIfAbsent(path, since) == null;
  }

  /** What held it last, until that is found and says that it does not any more. */
  @Nullable HoldReason last() {
    return last;
  }

  void last(@Nullable HoldReason reason) {
    last = reason;
  }

  /** What nobody knows of the last trip, as a clause; null where all is known. */
  @Nullable String unknown() {
    return unknown;
  }

  void unknown(@Nullable String why) {
    unknown = why;
  }

  /** The behaviours and effectors that the robot is known to have, by path. */
  Set<String> modules() {
    return Collections.unmodifiableSet(modules);
  }

  /** The robot has these modules; whether one of them was not known. */
  boolean add(Set<String> paths) {
    return modules.addAll(paths);
  }

  /** The robot has no modules but these. */
  void retain(Set<String> paths) {
    modules.retainAll(paths);
  }
}
