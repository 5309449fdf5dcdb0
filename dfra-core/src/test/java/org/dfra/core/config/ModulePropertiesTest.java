package org.dfra.core.config;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ModulePropertiesTest {

  @TempDir Path temp;

  private ModuleProperties read(String text) {
    return read(text.getBytes(StandardCharsets.UTF_8));
  }

  private ModuleProperties read(byte[] text) {
    try {
      Files.write(temp.resolve("m.properties"), text);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
    return ModuleProperties.read(temp.resolve("m.properties"), Map.of("RATE", "5")::get);
  }

  private List<String> complaints(String text) {
    return complaints(text.getBytes(StandardCharsets.UTF_8));
  }

  private List<String> complaints(byte[] text) {
    ConfigurationException complaint =
        catchThrowableOfType(ConfigurationException.class, () -> read(text));
    assertThat(complaint).as("properties that cannot be used were read").isNotNull();
    return complaint.getMessage().lines().map(line -> line.replace(temp + "/", "")).toList();
  }

  @Test
  void keysCarryTheLineTheyBeginIn() {
    ModuleProperties properties =
        read(
            "# a comment never continues \\\n"
                + "server = a.Server \n"
                + "\n"
                + "  ! another\r\n"
                + "proxy:a.\\\n"
                + "    Proxy\n"
                + "implementation a.Driver\r"
                + "parameter.rate=${RATE}\n"
                + "parameter.path=C:\\\\\n"
                + "parameter.note=caf\u00e9 \\u00fc $$\n");

    assertThat(properties.find("server")).map(Parameters.Value::text).contains("a.Server");
    assertThat(properties.find("proxy")).map(Parameters.Value::text).contains("a.Proxy");
    assertThat(properties.values().values())
        .extracting(value -> value.place().line())
        .containsExactly(2, 5, 7, 8, 9, 10);
    assertThat(properties.parameters())
        .hasSize(3)
        .hasEntrySatisfying("rate", rate -> assertThat(rate.text()).isEqualTo("5"))
        .hasEntrySatisfying("path", path -> assertThat(path.text()).isEqualTo("C:\\"))
        .hasEntrySatisfying("note", note -> assertThat(note.text()).isEqualTo("café ü $"));
  }

  @Test
  void byteOrderMarkIsNoPartOfTheFirstKey() {
    assertThat(read("\uFEFFserver=a.B").find("server")).isPresent();
  }

  @Test
  void missingFile() {
    ConfigurationException complaint =
        catchThrowableOfType(
            ConfigurationException.class, () -> ModuleProperties.read(temp.resolve("no")));

    assertThat(complaint)
        .hasMessage(
            temp.resolve("no") + ": there is no such file; name a module's properties file");
  }

  @Test
  void anotherEncoding() {
    assertThat(complaints("implementation=caf\u00e9".getBytes(StandardCharsets.ISO_8859_1)))
        .containsExactly("m.properties: the file is not UTF-8; save it in that encoding");
  }

  @Test
  void unknownKey() {
    assertThat(complaints("sevrer=a.B\nparamater.link=x\nlink=x\nparameter=x"))
        .containsExactly(
            "m.properties:1: \"sevrer\" is not a key of a module; did you mean \"server\"?",
            "m.properties:2: \"paramater.link\" is not a key of a module;"
                + " did you mean \"parameter.link\"?",
            "m.properties:3: \"link\" is not a key of a module; write server, proxy,"
                + " implementation or configuration, or parameter.link for a parameter",
            "m.properties:4: \"parameter\" is not a key of a module; did you mean \"parameter.\"?");
  }

  @Test
  void duplicateKey() {
    assertThat(complaints("implementation=a.B\n\nimplementation=a.C"))
        .containsExactly(
            "m.properties:3: the key \"implementation\" is written twice, first in line 1; delete one");
  }

  @Test
  void parameterWithoutOrderlyName() {
    assertThat(complaints("parameter.=x\nparameter.updateRate=1"))
        .containsExactly(
            "m.properties:1: the parameter name \"\" is not lower_snake_case;"
                + " write lower-case letters, digits and single underscores, beginning with a"
                + " letter",
            "m.properties:2: the parameter name \"updateRate\" is not lower_snake_case;"
                + " write \"update_rate\"");
  }

  @Test
  void badEscape() {
    assertThat(complaints("parameter.path=C:\\users"))
        .containsExactly(
            "m.properties:1: a \\u is not followed by four hexadecimal digits;"
                + " write them, or \\\\ for a backslash");
  }

  @Test
  void unsetVariables() {
    assertThat(complaints("parameter.a=${A}${B}"))
        .containsExactly(
            "m.properties:1: the variable A is not set; set it in the environment,"
                + " or write ${A:-default}",
            "m.properties:1: the variable B is not set; set it in the environment,"
                + " or write ${B:-default}");
  }
}
