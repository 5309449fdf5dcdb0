package org.dfra.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.UUID;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import net.jini.config.Configuration;
import net.jini.config.NoSuchEntryException;
import net.jini.core.entry.Entry;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.river.discovery.LocatedRegistrar;
import org.dfra.river.discovery.MulticastSearch;
import org.dfra.river.lease.ModuleLandlord;
import org.dfra.river.lookup.LookupJoin;
import org.junit.jupiter.api.Test;

/** The reference lists every entry that a module's Jini configuration may have. */
class ModuleConfigurationReferenceTest {

  private static final Path REFERENCE =
      Documents.ROOT.resolve("docs/reference/module-configuration.md");

  private static final Pattern HEADING = Pattern.compile("(?m)^###? `([\\w.]+)`$");
  private static final Pattern ROW =
      Pattern.compile("(?m)^\\| `(\\w+)` \\| `([\\w\\[\\]]+)` \\| ([^|]+) \\| [^|]+ \\|$");

  /** One row of the reference, or one question of the code. */
  private record Asked(String type, String fallback) {}

  /** Answers every question with its default, and remembers it. */
  private static final class Recorder implements Configuration {

    private final Map<String, Asked> asked = new TreeMap<>();

    @Override
    public Object getEntry(String component, String name, Class type) throws NoSuchEntryException {
      return getEntry(component, name, type, NO_DEFAULT);
    }

    @Override
    public Object getEntry(String component, String name, Class type, Object fallback, Object data)
        throws NoSuchEntryException {
      return getEntry(component, name, type, fallback);
    }

    @Override
    public Object getEntry(String component, String name, Class type, Object fallback)
        throws NoSuchEntryException {
      asked.put(component + "." + name, new Asked(type.getSimpleName(), String.valueOf(fallback)));
      if (fallback == NO_DEFAULT) {
        throw new NoSuchEntryException(component + "." + name); // River then makes one itself
      }
      return fallback;
    }
  }

  @Test
  void listsEveryEntryOfWhatAModuleIsMadeOfAndNoOther() throws Exception {
    Map<String, Asked> asked = new TreeMap<>(askedByLandlordAndJoin());
    asked.put("org.dfra.river.server.serverExporter", new Asked("Exporter", "made by the server"));

    Map<String, Asked> documented = documented();

    assertThat(documented.keySet()).as("entries in " + REFERENCE).isEqualTo(asked.keySet());
    asked.forEach(
        (name, question) -> {
          Asked output = documented.get(name);
          assertThat(output.type()).as("type of " + name).isEqualTo(question.type());
          boolean seen = !question.fallback().equals(String.valueOf(Configuration.NO_DEFAULT));
          if (seen && output.fallback().matches("`[^`]+`")) { // else asked through a wrapper
            assertThat(output.fallback())
                .as("default of " + name)
                .isEqualTo("`" + question.fallback() + "`");
          }
        });
  }

  @Test
  void theServersOwnEntryIsTheOneInItsSource() throws Exception {
    String source =
        Files.readString(
            Documents.ROOT.resolve(
                "dfra-river/src/main/java/org/dfra/river/server/ModulePartFactory.java"));

    List<String> read =
        Pattern.compile("getEntry\\(\\s*ModuleServer\\.COMPONENT,\\s*\"(\\w+)\"")
            .matcher(source)
            .results()
            .map(found -> found.group(1))
            .toList();

    assertThat(read)
        .as("entries that ModuleServer reads by its parts")
        .containsExactly("serverExporter");
  }

  private static Map<String, Asked> askedByLandlordAndJoin() throws Exception {
    Recorder recorder = new Recorder();
    String host = "127.0.0.1";
    assertThat(ModuleLandlord.terms(recorder)).isEqualTo(LeaseTerms.DEFAULT);
    try (LookupJoin unused =
        LookupJoin.start(
            "no proxy, but serializable",
            UUID.randomUUID(),
            new Entry[0],
            List.of(),
            List.of("jini://" + host + ":1"), // nobody is there
            recorder)) {
      assertThat(unused).isNotNull();
    }
    MulticastSearch.Listener nobody =
        new MulticastSearch.Listener() {
          @Override
          public void found(LocatedRegistrar registrar) {}

          @Override
          public void lost(LocatedRegistrar registrar) {}
        };
    MulticastSearch.start(new String[0], recorder, nobody).close(); // as with groups
    return recorder.asked;
  }

  private static Map<String, Asked> documented() throws Exception {
    String text = Files.readString(REFERENCE);
    Map<String, Asked> documented = new TreeMap<>();
    String component = "";
    for (String line : text.lines().toList()) {
      Matcher heading = HEADING.matcher(line);
      if (heading.matches()) {
        component = heading.group(1) + ".";
      }
      Matcher row = ROW.matcher(line);
      if (row.matches()) {
        documented.put(component + row.group(1), new Asked(row.group(2), row.group(3).trim()));
      }
    }
    return documented;
  }
}
