package org.dfra.behaviors.fuzzy;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.NearestName;
import org.dfra.core.config.SourceLocation;
import org.jspecify.annotations.Nullable;

/** The lines of a {@code .fis} file by section, without comments. */
final class FisDocument {

  private static final Pattern HEADING = Pattern.compile("\\[(\\w+)\\]");
  private static final Pattern ENTRY = Pattern.compile("(\\w+)\\s*=(.*)");

  private final String file;
  private final Map<String, Section> sections = new LinkedHashMap<>();

  private FisDocument(String file) {
    this.file = file;
  }

  /**
   * One line.
   *
   * @param key text before the {@code =}; empty in a rule
   * @param value text after it, or the whole line
   */
  record FisLine(String key, String value, SourceLocation place) {

    /** An error of this line. */
    ConfigurationException fault(String sentence) {
      return new ConfigurationException(place + ": " + sentence);
    }
  }

  /** A section. */
  record Section(String name, SourceLocation place, List<FisLine> lines) {

    /** The line of a key. */
    FisLine line(String key) {
      return lines.stream()
          .filter(line -> line.key().equals(key))
          .findFirst()
          .orElseThrow(
              () ->
                  new ConfigurationException(
                      place + ": [" + name + "] has no " + key + "; write " + key + "=…"));
    }

    /** The lines of a key followed by 1, 2, 3 and so on. */
    List<FisLine> numbered(String key) {
      List<FisLine> found =
          lines.stream().filter(line -> line.key().matches(key + "\\d+")).toList();
      for (int i = 0; i < found.size(); i++) {
        if (!found.get(i).key().equals(key + (i + 1))) {
          FisLine line = found.get(i);
          throw line.fault(
              line.key() + " is in the place of " + key + (i + 1) + "; number them from 1 on");
        }
      }
      return found;
    }

    /** Reports an error for a key that is none of these. */
    void requireKnown(Collection<String> keys) {
      for (FisLine line : lines) {
        if (!keys.contains(line.key())) {
          throw line.fault(
              "\""
                  + line.key()
                  + "\" is not a key of ["
                  + name
                  + "]"
                  + NearestName.hint(line.key(), keys, "; use one of " + keys));
        }
      }
    }
  }

  static FisDocument of(String text, String file) {
    FisDocument sections = new FisDocument(file);
    @Nullable Section section = null;
    int number = 0;
    for (String raw : text.lines().toList()) {
      SourceLocation place = new SourceLocation(file, ++number);
      String line = raw.strip().replaceFirst("^\uFEFF", "");
      if (line.isEmpty() || line.startsWith("%") || line.startsWith("#")) {
        continue;
      }
      Matcher heading = HEADING.matcher(line);
      if (heading.matches()) {
        section = sections.begin(heading.group(1), place);
      } else if (section == null) {
        throw new ConfigurationException(
            place + ": \"" + line + "\" is before the first heading; begin with [System]");
      } else {
        section.lines().add(entry(section, line, place));
      }
    }
    return sections;
  }

  private Section begin(String name, SourceLocation place) {
    Section section = new Section(name, place, new ArrayList<>());
    @Nullable Section former = sections.put(name, section);
    if (former != null) {
      throw new ConfigurationException(
          place
              + ": ["
              + name
              + "] is written twice, first in line "
              + former.place().line()
              + "; delete one");
    }
    return section;
  }

  private static FisLine entry(Section section, String line, SourceLocation place) {
    if (section.name().equals("Rules")) {
      return new FisLine("", line, place);
    }
    Matcher entry = ENTRY.matcher(line);
    if (!entry.matches()) {
      throw new ConfigurationException(
          place + ": \"" + line + "\" is neither key=value nor a [Heading] nor a comment");
    }
    String key = entry.group(1);
    if (section.lines().stream().anyMatch(other -> other.key().equals(key))) {
      throw new ConfigurationException(
          place + ": " + key + " is written twice in [" + section.name() + "]; delete one");
    }
    return new FisLine(key, entry.group(2), place);
  }

  /** The section of that name. */
  Section section(String name) {
    @Nullable Section section = sections.get(name);
    if (section == null) {
      throw new ConfigurationException(
          file
              + ": the section ["
              + name
              + "] is missing; check that this is a complete .fis file");
    }
    return section;
  }

  /** Reports errors for sections beyond the size of the system. */
  void requireKnown(int inputs, int outputs) {
    for (Section section : sections.values()) {
      Matcher numbered = Pattern.compile("(Input|Output)(\\d{1,6})").matcher(section.name());
      boolean isKnown =
          section.name().equals("System")
              || section.name().equals("Rules")
              || (numbered.matches()
                  && Integer.parseInt(numbered.group(2))
                      <= (numbered.group(1).equals("Input") ? inputs : outputs));
      if (!isKnown) {
        throw new ConfigurationException(
            section.place()
                + ": ["
                + section.name()
                + "] is not a section of this system, which has "
                + inputs
                + " inputs and "
                + outputs
                + " outputs; rename or delete it");
      }
    }
  }
}
