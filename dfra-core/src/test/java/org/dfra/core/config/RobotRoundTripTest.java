package org.dfra.core.config;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dfra.core.config.RobotXml.RobotXmlSchema;
import org.dfra.persona.PersonaAttributes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RobotRoundTripTest {

  @TempDir Path temp;

  @Test
  void whatIsWrittenReadsBackEqual() throws IOException {
    RobotFolder folder = new RobotFolder(temp);
    folder.write("module.config", "");
    folder.write("a.jar", "");
    folder.write("b.jar", "");
    folder
        .properties(
            RobotFolder.CLASSES
                + "configuration=module.config\n"
                + "codebase=a.jar,b.jar\n"
                + "parameter.odd=\\ a\\tb\\nc\\rd $$ ${HOST} <>&\\\"' caf\u00e9 \\uD83D\\uDE80 \n")
        .xml(
            "<lookup groups=\"field,north\" locators=\"base,relay:4161\"/>",
            "<administration from=\"10.0.0.7, fd00::/8,${ADMIN:-base}.local\"/>",
            "<persona role=\"scout $$\"><goal> Map ${HOST} &amp; all. </goal>",
            "<limitation>no stairs</limitation><goal>Come back.</goal></persona>",
            "<group name=\"lookup\"><registrar port=\"4170\" class-server-port=\"off\" restart=\"false\"",
            " module-hosts=\"10.0.0.8,second.local\"/></group>",
            "<group name=\"gps\"><jvm-option>-Da=b  c $$</jvm-option>",
            "<jvm-option>-Xmx64m</jvm-option>",
            "<module name=\"front\" properties=\"gps.properties\" restart=\"false\">",
            "<parameter name=\"link\" value=\"${HOST}\"/></module>",
            "<module name=\"rear\" properties=\"gps.properties\"/></group>",
            "<group name=\"empty\"/>");
    folder.variables.put("HOST", "$$ {} ${A:-b}");
    RobotDescription robot = folder.read();

    Path dump = folder.path("dump.xml");
    RobotXml.write(robot, dump);
    RobotDescription again = RobotXml.read(dump, name -> null);

    assertThat(again)
        .usingRecursiveComparison()
        .ignoringFields("source")
        .ignoringFieldsOfTypes(SourceLocation.class)
        .isEqualTo(robot);
    assertThat(robot.modules().get(0).parameters().text("odd"))
        .as("the odd characters got as far as the dump")
        .isEqualTo(" a\tb\nc\rd $ $$ {} ${A:-b} <>&\"' café \uD83D\uDE80 ");
    assertThat(robot.persona())
        .contains(
            new PersonaAttributes(
                "atrv1",
                "scout $",
                List.of("Come back.", "Map $$ {} ${A:-b} & all."),
                List.of("no stairs")));
    assertThat(RobotXml.toXml(again)).isEqualTo(RobotXml.toXml(robot));
  }

  @Test
  void aWrittenFileIsValidatedAgainIfSomebodyEditsIt() throws Exception {
    RobotDescription robot = new RobotFolder(temp).module().read();
    Path dump = temp.resolve("dump.xml");
    RobotXml.write(robot, dump);
    assertThat(RobotXml.read(dump, name -> null).name()).isEqualTo(robot.name());

    String edited = Files.readString(dump).replaceFirst("<robot ", "<robot wheels=\"4\" ");
    Files.writeString(dump, edited);
    assertThatThrownBy(() -> RobotXml.read(dump, name -> null))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("dump.xml:2: ")
        .hasMessageContaining("wheels");
  }

  @Test
  void aMarkedDocumentIsNotValidatedAgain() {
    String invalid = "<robot xmlns='urn:dfra:robot:1' name='a' wheels='4'/>\n";
    SourceLocation whole = new SourceLocation("robot.xml", 0);
    ConfigurationFaults faults = new ConfigurationFaults();
    byte[] text = RobotXmlSchema.ROBOT.marked(invalid).getBytes(StandardCharsets.UTF_8);
    Object unused = RobotXmlSchema.ROBOT.read(text, whole, faults);
    faults.throwIfAny();

    text = invalid.getBytes(StandardCharsets.UTF_8);
    Object unusedEither = RobotXmlSchema.ROBOT.read(text, whole, faults);
    assertThatThrownBy(faults::throwIfAny).hasMessageContaining("wheels");
  }

  @Test
  void whatXmlCannotWriteIsRefusedByName() {
    RobotDescription robot =
        new RobotFolder(temp)
            .properties(RobotFolder.CLASSES + "parameter.wake=\\u0007")
            .module()
            .read();

    assertThatThrownBy(() -> RobotXml.toXml(robot))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            temp.resolve("gps.properties")
                + ":4: parameter wake of atrv1/gps_front holds a character that XML cannot write;"
                + " leave it out");
  }
}
