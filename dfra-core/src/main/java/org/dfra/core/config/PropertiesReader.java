package org.dfra.core.config;

import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Properties;

/**
 * Reads one properties file. This class finds the logical lines, for their line numbers; {@link
 * Properties} parses them.
 */
final class PropertiesReader {

  private final Path file;
  private final Substitution substitution;
  private final ConfigurationFaults faults;
  private final Map<String, SourceLocation> places = new HashMap<>();
  private final Map<String, Parameters.Value> values = new LinkedHashMap<>();
  private boolean readable;

  PropertiesReader(Path file, Substitution substitution, ConfigurationFaults faults) {
    this.file = file;
    this.substitution = substitution;
    this.faults = faults;
  }

  /** Whether the file could be read. */
  boolean isReadable() {
    return readable;
  }

  /** Whether the key was present, perhaps with an invalid value. */
  boolean hasKey(String key) {
    return places.containsKey(key);
  }

  /** The valid entries; the others are among the faults. */
  ModuleProperties read() {
    SourceLocation whole = new SourceLocation(file.toString(), 0);
    try {
      String text = Files.readString(file);
      readable = true;
      lines(text.startsWith("\uFEFF") ? text.substring(1) : text);
    } catch (NoSuchFileException e) {
      faults.add(whole, "there is no such file; name a module's properties file");
    } catch (CharacterCodingException e) {
      faults.add(whole, "the file is not UTF-8; save it in that encoding");
    } catch (IOException e) {
      faults.add(whole, "the file cannot be read (" + e + "); name a readable file");
    }
    return new ModuleProperties(file, values);
  }

  private void lines(String text) {
    List<String> lines = text.lines().toList();
    for (int i = 0; i < lines.size(); i++) {
      SourceLocation place = new SourceLocation(file.toString(), i + 1);
      StringBuilder logical = new StringBuilder(lines.get(i));
      if (!isComment(lines.get(i))) {
        while (isContinued(lines.get(i)) && i + 1 < lines.size()) {
          logical.append('\n').append(lines.get(++i));
        }
      }
      line(logical.toString(), place);
    }
  }

  private void line(String logical, SourceLocation place) {
    Properties properties = new Properties();
    try {
      properties.load(new StringReader(logical));
    } catch (IllegalArgumentException e) {
      faults.add(
          place,
          "a \\u is not followed by four hexadecimal digits; write them, or \\\\ for a backslash");
    } catch (IOException e) {
      throw new UncheckedIOException(e); // a text in memory is always readable
    }
    properties.stringPropertyNames().forEach(key -> key(key, properties.getProperty(key), place));
  }

  private void key(String written, String text, SourceLocation place) {
    String key = RenamedNames.resolve(RenamedNames.PROPERTIES, place, "the key", written);
    SourceLocation first = places.putIfAbsent(key, place);
    boolean isParameter = key.startsWith(ModuleProperties.PARAMETER);
    if (first != null) {
      faults.add(
          place,
          "the key \""
              + key
              + (key.equals(written) ? "\"" : "\" (" + written + " is its old name)")
              + " is written twice, first in line "
              + first.line()
              + "; delete one");
    } else if (!isParameter && !ModuleProperties.KEYS.contains(key)) {
      faults.add(place, "\"" + key + "\" is not a key of a module" + hint(key));
    } else {
      String fault =
          isParameter
              ? DescriptionRules.name(
                  "parameter", key.substring(ModuleProperties.PARAMETER.length()))
              : null;
      if (fault != null) {
        faults.add(place, fault);
      }
      String value = substitution.apply(text, place);
      if (value != null) {
        values.put(key, new Parameters.Value(isParameter ? value : value.strip(), place));
      }
    }
  }

  private static String hint(String key) {
    int dot = key.indexOf('.') + 1;
    String rest = key.substring(dot);
    if (dot > 0 && NearestName.isNear(key.substring(0, dot), ModuleProperties.PARAMETER)) {
      return "; did you mean \"" + ModuleProperties.PARAMETER + rest + "\"?";
    }
    return NearestName.hint(
        key,
        ModuleProperties.KEYS,
        "; write server, proxy, implementation or configuration, or parameter."
            + key
            + " for a parameter");
  }

  private static boolean isComment(String line) {
    String text = line.stripLeading();
    return text.startsWith("#") || text.startsWith("!");
  }

  /** Whether the line ends in an odd number of backslashes. */
  private static boolean isContinued(String line) {
    int end = line.length();
    while (end > 0 && line.charAt(end - 1) == '\\') {
      end--;
    }
    return (line.length() - end) % 2 == 1;
  }
}
