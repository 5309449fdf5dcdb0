package org.dfra.cli;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import picocli.CommandLine;

/**
 * The subcommands that other modules provide. Each of these modules lists its subcommands in a
 * resource {@value #RESOURCE}: in each line the words that are typed, and the name of the class.
 * Lines that start with {@code #} are comments. So the command line needs no class of those
 * modules, and a robot can do without them.
 */
final class ProvidedCommands {

  private static final String RESOURCE = "META-INF/dfra/commands";

  /** The modules of DFRA that provide subcommands, for the message that one is missing. */
  private static final Map<String, String> MODULES =
      Collections.unmodifiableMap(
          new TreeMap<>(
              Map.ofEntries(
                  Map.entry("security init", "dfra-authority"),
                  Map.entry("security issue", "dfra-authority"),
                  Map.entry("security list", "dfra-authority"),
                  Map.entry("security publish", "dfra-authority"),
                  Map.entry("security renew", "dfra-authority"),
                  Map.entry("security revoke", "dfra-authority"),
                  Map.entry("fuzzy", "dfra-examples"),
                  Map.entry("demo", "dfra-examples"),
                  Map.entry("sim", "dfra-examples"),
                  Map.entry("recruit experiment", "dfra-experiments"),
                  Map.entry("bench", "dfra-benchmarks"))));

  /** A line of a resource. */
  private record Entry(URL resource, String className) {}

  private final Map<String, Entry> entries; // by the words that are typed

  private ProvidedCommands(Map<String, Entry> entries) {
    this.entries = entries;
  }

  /** Those on the class path. Loads none of their classes. */
  static ProvidedCommands installed() {
    Map<String, Entry> entries = new LinkedHashMap<>();
    try {
      for (URL each : Collections.list(loader().getResources(RESOURCE))) {
        read(each, entries);
      }
    } catch (IOException e) {
      throw new UncheckedIOException("the jars' " + RESOURCE + " cannot be read", e);
    }
    return new ProvidedCommands(entries);
  }

  private static void read(URL resource, Map<String, Entry> entries) throws IOException {
    try (BufferedReader lines =
        new BufferedReader(new InputStreamReader(resource.openStream(), StandardCharsets.UTF_8))) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        String entry = line.strip();
        int end = entry.lastIndexOf(' ');
        if (entry.isEmpty() || entry.startsWith("#")) {
          continue;
        } else if (end < 0) {
          throw new IllegalStateException(
              resource + ": \"" + entry + "\" is not the words of a command and a class");
        }
        entries.put(entry.substring(0, end).strip(), new Entry(resource, entry.substring(end + 1)));
      }
    }
  }

  /** The words of the provided subcommands, also of those that are not installed. */
  static Set<String> known() {
    return MODULES.keySet();
  }

  /** The module of DFRA that provides a subcommand. */
  static String module(String words) {
    return Objects.requireNonNull(MODULES.get(words), words);
  }

  /** Whether other modules provide subcommands of this subcommand. */
  static boolean mayExtend(String verb) {
    return MODULES.keySet().stream().anyMatch(each -> each.startsWith(verb + " "));
  }

  /** The words of those on the class path. */
  Set<String> words() {
    return entries.keySet();
  }

  /** Where the resource lies that names a subcommand, as a URL. */
  String place(String words) {
    return Objects.requireNonNull(entries.get(words), words).resource().toString();
  }

  /** The class of a subcommand; empty if no module on the class path provides it. */
  Optional<Class<?>> find(String words) {
    return Optional.ofNullable(entries.get(words)).map(each -> load(words, each));
  }

  private static Class<?> load(String words, Entry entry) {
    try {
      return Class.forName(entry.className(), false, loader());
    } catch (ClassNotFoundException e) {
      throw new IllegalStateException(
          entry.resource()
              + " names the class "
              + entry.className()
              + " for "
              + words
              + ", which no jar has",
          e);
    }
  }

  /** Adds what is provided for a subcommand. */
  void extend(String verb, CommandLine line) {
    for (String words : entries.keySet()) {
      if (words.startsWith(verb + " ")) {
        find(words).ifPresent(line::addSubcommand);
      }
    }
  }

  /**
   * Why a command that DFRA has cannot be run here.
   *
   * @param words what was typed
   * @return a sentence; empty if the command does not belong to another module, or is installed
   */
  Optional<String> missing(String... words) {
    String typed = String.join(" ", words) + " ";
    return MODULES.entrySet().stream()
        .filter(each -> typed.startsWith(each.getKey() + " "))
        .filter(each -> !entries.containsKey(each.getKey()))
        .map(each -> each.getKey() + " is in " + each.getValue() + ", which is not installed")
        .findFirst();
  }

  private static ClassLoader loader() {
    return ProvidedCommands.class.getClassLoader();
  }
}
