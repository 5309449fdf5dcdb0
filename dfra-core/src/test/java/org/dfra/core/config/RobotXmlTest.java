package org.dfra.core.config;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.dfra.core.config.RobotDescription.GroupDescription;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RobotXmlTest {

  @TempDir Path temp;

  private RobotFolder folder() {
    return new RobotFolder(temp);
  }

  @Test
  void readsEverythingThatIsWritten() {
    RobotFolder folder =
        folder()
            .document(
                """
                <robot xmlns="urn:dfra:robot:1" name="atrv1" host="${DFRA_HOST:-auto}">
                  <lookup groups="field, north" locators="base, jini://relay:4161/"/>
                  <group name="lookup">
                    <registrar port="${DFRA_PORT:-4170}" class-server-port="8090" restart="false"/>
                  </group>
                  <group name="gps">
                    <jvm-option>-Xmx64m</jvm-option>
                    <jvm-option> -Dx=${DFRA_HOST} </jvm-option>
                    <module name="gps_front" properties="gps.properties" restart="false">
                      <parameter name="link" value="tcp://${DFRA_HOST}:4001"/>
                    </module>
                  </group>
                </robot>
                """)
            .properties(RobotFolder.CLASSES + "parameter.link=unused\nparameter.period=1\n");
    folder.variables.put("DFRA_HOST", "10.0.0.7");

    RobotDescription robot = folder.read();

    assertThat(robot.name()).isEqualTo("atrv1");
    assertThat(robot.host()).isEqualTo("10.0.0.7");
    assertThat(robot.lookupGroups()).containsExactly("field", "north");
    assertThat(robot.locators()).containsExactly("jini://base", "jini://relay:4161");
    assertThat(robot.source()).isEqualTo(folder.path("robot.xml"));
    String xml = folder.path("robot.xml").toString();
    assertThat(robot.registrar())
        .contains(new RegistrarDescription(4170, 8090, false, new SourceLocation(xml, 4)));
    GroupDescription gps = robot.groups().get(1);
    assertThat(gps.name()).isEqualTo("gps");
    assertThat(gps.jvmOptions()).containsExactly("-Xmx64m", "-Dx=10.0.0.7");
    assertThat(gps.registrar()).isEmpty();
    ModuleDescription module = robot.modules().get(0);
    assertThat(module.path()).isEqualTo("atrv1/gps_front");
    assertThat(module.serverClass()).isEqualTo("org.dfra.river.server.sensor.GPSServer");
    assertThat(module.proxyClass()).isEqualTo("org.dfra.river.proxy.sensor.GPSProxy");
    assertThat(module.driverClass()).isEqualTo("org.dfra.drivers.gps.m12.M12PlusImpl");
    assertThat(module.configuration()).isNull();
    assertThat(module.restart()).isFalse();
    assertThat(module.place()).isEqualTo(new SourceLocation(xml, 9));
    assertThat(module.parameters().all())
        .containsEntry(
            "link", new Parameters.Value("tcp://10.0.0.7:4001", new SourceLocation(xml, 10)))
        .containsEntry(
            "period",
            new Parameters.Value(
                "1", new SourceLocation(folder.path("gps.properties").toString(), 5)));
  }

  @Test
  void takesWhatIsUsualForWhatIsLeftOut() {
    RobotDescription robot =
        folder()
            .xml(
                "<group name=\"all\"><registrar/>",
                "<module name=\"gps\" properties=\"gps.properties\"/></group>")
            .read();

    assertThat(robot.host()).isEqualTo("auto");
    assertThat(robot.lookupGroups()).isEmpty();
    assertThat(robot.locators()).isEmpty();
    assertThat(robot.registrar()).map(RegistrarDescription::port).contains(4160);
    assertThat(robot.registrar()).map(RegistrarDescription::classServerPort).contains(8085);
    assertThat(robot.registrar()).map(RegistrarDescription::restart).contains(true);
    assertThat(robot.modules()).allMatch(module -> module.codebase().isEmpty());
    assertThat(robot.modules()).allMatch(ModuleDescription::restart);
  }

  @Test
  void emptyLookupMeansNoneAndBlankItemsAreSkipped() {
    RobotDescription robot =
        folder()
            .xml("<lookup groups=\"\" locators=\" , base,,base \"/>", "<group name=\"all\"/>")
            .read();

    assertThat(robot.lookupGroups()).isEmpty();
    assertThat(robot.locators()).containsExactly("jini://base");
  }

  @Test
  void aLocatorMayBeAnAddressOfEitherKind() {
    RobotDescription robot =
        folder()
            .xml("<lookup locators=\"192.168.1.4:4170,[fe80::1]:4160\"/>", "<group name=\"a\"/>")
            .read();

    assertThat(robot.locators())
        .containsExactly("jini://192.168.1.4:4170", "jini://[fe80::1]:4160");
  }

  @Test
  void theXmlMayNameTheClassesItself() {
    ModuleDescription module =
        folder()
            .xml(
                "<group name=\"all\">",
                "<module name=\"gps\" properties=\"gps.properties\" implementation=\"a.Other\"/>",
                "<module name=\"own\" server=\"S\" proxy=\"P\" implementation=\"D\"/></group>")
            .readModule();

    assertThat(module.driverClass()).isEqualTo("a.Other");
    assertThat(module.proxyClass()).isEqualTo("org.dfra.river.proxy.sensor.GPSProxy");
  }

  @Test
  void aConfigurationIsRelativeToTheFileThatNamesIt() {
    RobotFolder folder = folder();
    folder.write("module.config", "");
    folder.properties(RobotFolder.CLASSES + "configuration=module.config\n").module();

    assertThat(folder.readModule().configuration())
        .isEqualTo(folder.path("module.config").toAbsolutePath().toString());
  }

  @Test
  void jarsToDownloadAreRelativeToTheFileThatNamesThem() {
    RobotFolder folder = folder();
    folder.write("a.jar", "");
    folder.write("b.jar", "");
    folder.properties(RobotFolder.CLASSES + "codebase=a.jar, b.jar,a.jar,\n").module();
    assertThat(folder.readModule().codebase())
        .containsExactly(
            folder.path("a.jar").toAbsolutePath().toString(),
            folder.path("b.jar").toAbsolutePath().toString());

    folder.properties(RobotFolder.CLASSES + "codebase=b.jar,c.jar\n");
    assertThat(folder.complaints())
        .containsExactly(
            "gps.properties:4: the codebase file \"c.jar\" of module gps_front does not exist;"
                + " name one, relative to gps.properties");
  }

  @Test
  void aRobotMayRunNoClassServer() {
    RobotFolder folder =
        folder().xml("<group name=\"a\"><registrar class-server-port=\"off\"/></group>");
    assertThat(folder.read().registrar().orElseThrow().hasClassServer()).isFalse();

    for (String wrong : List.of("0", "x", "")) {
      folder.xml("<group name=\"a\"><registrar class-server-port=\"" + wrong + "\"/></group>");
      assertThat(folder.complaints())
          .containsExactly(
              "robot.xml:2: the class server's port is \""
                  + wrong
                  + "\"; write a whole number from 1 to 65535, or off");
    }
  }

  @Test
  void systemPropertiesGoBeforeTheEnvironment() {
    RobotFolder folder = folder().xml("<lookup groups=\"${PATH}\"/>", "<group name=\"a\"/>");

    assertThat(RobotXml.read(folder.path("robot.xml")).lookupGroups())
        .containsExactly(System.getenv("PATH"));

    System.setProperty("PATH", "mine");
    try {
      assertThat(RobotXml.read(folder.path("robot.xml")).lookupGroups()).isEqualTo(List.of("mine"));
    } finally {
      System.clearProperty("PATH");
    }
  }

  @Test
  void aSchemaLocationForEditorsIsNotFetched() {
    RobotDescription robot =
        folder()
            .document(
                """
                <robot xmlns="urn:dfra:robot:1" name="atrv1"
                    xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
                    xsi:schemaLocation="urn:dfra:robot:1 http://127.0.0.1:1/robot.xsd">
                  <group name="all"/>
                </robot>
                """)
            .read();

    assertThat(robot.name()).isEqualTo("atrv1");
  }
}
