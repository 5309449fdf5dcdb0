package org.dfra.river.security.robot;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dfra.core.host.PrivateFiles;

/**
 * The named facts of a robot, in a file that its processes share: a line each, of name, value, time
 * and who has set it, separated by tabs. Thread-safe, also between processes.
 */
final class FactFile {

  /** The most facts. */
  static final int MAX_FACTS = 64;

  private static final String NAME = "facts.tsv";
  private static final String LOCK = "facts.lock";
  private static final int FIELDS = 4;

  /** A lock of a file excludes other processes only. */
  private static final Object THIS_PROCESS = new Object();

  private final Path folder;
  private final Path file;

  /**
   * @param folder made when it is first written to
   */
  FactFile(Path folder) {
    this.folder = folder;
    this.file = folder.resolve(NAME);
  }

  /** What changes when the file does; empty if there is none. */
  List<Object> state() throws IOException {
    try {
      BasicFileAttributes now = Files.readAttributes(file, BasicFileAttributes.class);
      return List.of(now.lastModifiedTime(), now.size(), String.valueOf(now.fileKey()));
    } catch (NoSuchFileException e) {
      return List.of();
    }
  }

  /**
   * The facts by name.
   *
   * @throws IOException if the file cannot be read, or a line is no fact; the message names it
   */
  Map<String, NamedFact> read() throws IOException {
    Map<String, NamedFact> facts = new TreeMap<>();
    List<String> lines;
    try {
      lines = Files.readAllLines(file);
    } catch (NoSuchFileException e) {
      return facts;
    }
    for (int i = 0; i < lines.size(); i++) {
      String[] fields = lines.get(i).split("\t", -1);
      try {
        if (fields.length != FIELDS) {
          throw new IllegalArgumentException("it has " + fields.length + " fields, not " + FIELDS);
        }
        NamedFact fact = new NamedFact(fields[0], fields[1], Instant.parse(fields[2]), fields[3]);
        facts.put(fact.name(), fact);
      } catch (IllegalArgumentException | DateTimeException e) {
        throw new IOException(
            file
                + ":"
                + (i + 1)
                + " is no fact ("
                + e.getMessage()
                + "); correct the line or delete the file",
            e);
      }
    }
    return facts;
  }

  /**
   * Sets a fact.
   *
   * @throws IllegalArgumentException if there are too many
   */
  void set(NamedFact fact) throws IOException {
    change(
        facts -> {
          facts.put(fact.name(), fact);
          if (facts.size() > MAX_FACTS) {
            throw new IllegalArgumentException(
                "a robot has at most " + MAX_FACTS + " facts; give one no value");
          }
        });
  }

  /** Removes a fact, if it is set. */
  void remove(String name) throws IOException {
    change(facts -> facts.remove(name));
  }

  private interface Change {
    void apply(Map<String, NamedFact> facts);
  }

  private void change(Change change) throws IOException {
    PrivateFiles.requireFolder(folder);
    Path lock = folder.resolve(LOCK);
    PrivateFiles.makeFile(lock);
    synchronized (THIS_PROCESS) {
      try (FileChannel channel = FileChannel.open(lock, StandardOpenOption.WRITE);
          FileLock unused = channel.lock()) {
        Map<String, NamedFact> facts = read();
        change.apply(facts);
        PrivateFiles.write(file, text(facts).getBytes(StandardCharsets.UTF_8));
      }
    }
  }

  private static String text(Map<String, NamedFact> facts) {
    List<String> lines = new ArrayList<>();
    for (NamedFact each : facts.values()) {
      lines.add(
          String.join(
              "\t",
              each.name(),
              each.value(),
              each.set().toString(),
              each.by().replaceAll("\\p{Cntrl}", " ")));
    }
    return lines.isEmpty() ? "" : String.join("\n", lines) + "\n";
  }
}
