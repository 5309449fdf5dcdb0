package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationSystem;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import net.jini.config.Configuration;
import net.jini.config.NoSuchEntryException;
import net.jini.export.Exporter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The reference lists every entry that phoenix and its groups read, with type and default. */
class PhoenixReferenceTest {

  private static final Path REFERENCE =
      Path.of(Objects.requireNonNull(System.getProperty("dfra.root"), "dfra.root is not set"))
          .resolve("docs/reference/phoenix.md");

  private static final String GROUP_COMPONENT = "org.dfra.river.phoenix.group";

  /** {@code | `name` | `Type` | default | meaning |}. */
  private static final Pattern ROW =
      Pattern.compile("(?m)^\\| `(\\w+)` \\| `([\\w\\[\\]]+)` \\| ([^|]+) \\| [^|]+ \\|$");

  @TempDir Path folder;

  /** One row of the reference, or one question of the code. */
  private record Entry(String type, String fallback) {}

  /** Answers every question with its default, and remembers it. */
  public static final class Recorder implements Configuration {

    private static final List<Recorder> MADE = new ArrayList<>();

    private final Map<String, Entry> asked = new TreeMap<>();

    /** As a configuration provider is made; the arguments are not looked at. */
    public Recorder(String[] arguments, ClassLoader loader) {
      MADE.add(this);
    }

    @Override
    public Object getEntry(String component, String name, Class type) throws NoSuchEntryException {
      if (type != String.class) {
        throw new NoSuchEntryException("nothing is set under " + name); // an old or new name
      }
      asked.put(component + "." + name, new Entry(type.getSimpleName(), "required"));
      return "nowhere"; // the one required entry is a folder, which reading does not touch
    }

    @Override
    public Object getEntry(String component, String name, Class type, Object fallback) {
      asked.put(component + "." + name, new Entry(type.getSimpleName(), text(fallback)));
      return fallback;
    }

    @Override
    public Object getEntry(
        String component, String name, Class type, Object fallback, Object data) {
      return getEntry(component, name, type, fallback);
    }

    private static String text(Object fallback) {
      if (fallback instanceof String[] texts) {
        return String.join(", ", texts);
      }
      return String.valueOf(fallback);
    }
  }

  @Test
  void listsEveryEntryOfPhoenixAndNoOther() throws Exception {
    Recorder recorder = new Recorder(new String[0], getClass().getClassLoader());
    PhoenixConfiguration.read(recorder, SecretIdentities.fresh());

    compare(recorder.asked, PhoenixConfiguration.COMPONENT, section("## Entries\n"));
  }

  @Test
  void listsEveryEntryOfAGroupAndNoOther() throws Exception {
    compare(askedByAGroup(), GROUP_COMPONENT, section("## Entries of a group\n"));
  }

  @Test
  void namesTheExitCodesAndTheMarks() throws IOException {
    assertThat(Files.readString(REFERENCE))
        .contains("\n| " + GroupVm.EXIT_NO_GROUP + " |")
        .contains("\n| " + GroupVm.EXIT_LOCKED + " |")
        .contains("\n| " + GroupVm.EXIT_REFUSED + " |")
        .contains("`" + GroupProcess.GROUP_PROPERTY + "`")
        .contains("`" + GroupProcess.LOCK_PROPERTY + "`")
        .contains("`" + GroupProcess.OUTPUT_PROPERTY + "`")
        .contains("`" + Phoenix.GROUP_NAME + "`")
        .contains("port " + PhoenixConfiguration.DEFAULT_PORT);
  }

  /** What a group asks when it is constructed; it goes no further than exporting itself. */
  private Map<String, Entry> askedByAGroup() throws Exception {
    Path services = Files.createDirectories(folder.resolve("META-INF/services"));
    Files.writeString(services.resolve(Configuration.class.getName()), Recorder.class.getName());
    Thread thread = Thread.currentThread();
    ClassLoader before = thread.getContextClassLoader();
    Recorder.MADE.clear();
    try (URLClassLoader loader =
        new URLClassLoader(new URL[] {folder.toUri().toURL()}, getClass().getClassLoader())) {
      thread.setContextClassLoader(loader);
      ActivationSystem none = null;
      Object group = new ActivationGroupImpl(new ActivationGroupID(none), null);
      ((Exporter) read(group, "exporter")).unexport(true);
    } finally {
      thread.setContextClassLoader(before);
    }
    assertThat(Recorder.MADE).as("configurations the group has read").hasSize(1);
    return Recorder.MADE.get(0).asked;
  }

  private static Object read(Object from, String field) throws ReflectiveOperationException {
    java.lang.reflect.Field declared = from.getClass().getDeclaredField(field);
    declared.setAccessible(true);
    return declared.get(from);
  }

  private static void compare(Map<String, Entry> asked, String component, String section) {
    Map<String, Entry> documented = new TreeMap<>();
    Matcher row = ROW.matcher(section);
    while (row.find()) {
      documented.put(component + "." + row.group(1), new Entry(row.group(2), row.group(3).trim()));
    }
    assertThat(asked).as("entries that the code asks for").isNotEmpty();
    assertThat(documented.keySet()).as("entries in " + REFERENCE).isEqualTo(asked.keySet());
    asked.forEach(
        (name, entry) -> {
          Entry written = documented.get(name);
          assertThat(written.type()).as("type of " + name).isEqualTo(entry.type());
          if (written.fallback().matches("`[^`]+`")) {
            assertThat(written.fallback()).as("default of " + name).isEqualTo(quoted(entry));
          } else if (written.fallback().equals("none")) {
            assertThat(entry.fallback()).as("default of " + name).isIn("null", "");
          } else if (written.fallback().equals("required")) {
            assertThat(entry.fallback()).as("default of " + name).isEqualTo("required");
          }
        });
  }

  private static String quoted(Entry entry) {
    return "`" + entry.fallback() + "`";
  }

  /** The text from a second-level heading to the next one. */
  private static String section(String heading) throws IOException {
    String text = Files.readString(REFERENCE);
    int begin = text.indexOf("\n" + heading);
    assertThat(begin).as("where " + REFERENCE + " has " + heading.trim()).isNotNegative();
    int end = text.indexOf("\n## ", begin + heading.length());
    return text.substring(begin, end < 0 ? text.length() : end);
  }
}
