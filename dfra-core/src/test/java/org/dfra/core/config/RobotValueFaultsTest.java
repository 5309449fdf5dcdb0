package org.dfra.core.config;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is said of a robot's XML whose structure is right. */
class RobotValueFaultsTest {

  @TempDir Path temp;

  private RobotFolder folder() {
    return new RobotFolder(temp);
  }

  @Test
  void noGroup() {
    assertThat(folder().xml("<lookup/>").complaints())
        .containsExactly(
            "robot.xml:1: the robot has no group; add a <group>, since a group runs its modules");
  }

  @Test
  void duplicateGroup() {
    assertThat(folder().xml("<group name=\"a\"/>", "<group name=\"a\"/>").complaints())
        .containsExactly(
            "robot.xml:3: there is a second group a, the first is in line 2;"
                + " rename one, or make them one");
  }

  @Test
  void duplicateModuleEvenInAnotherGroup() {
    String module = "<module name=\"gps\" properties=\"gps.properties\"/></group>";
    assertThat(
            folder().xml("<group name=\"a\">", module, "<group name=\"b\">", module).complaints())
        .containsExactly(
            "robot.xml:5: there is a second module gps, the first is in line 3;"
                + " rename one, in whichever group it is");
  }

  @Test
  void twoRegistrars() {
    assertThat(
            folder()
                .xml(
                    "<group name=\"a\">",
                    "<registrar/></group>",
                    "<group name=\"b\"><registrar/></group>")
                .complaints())
        .containsExactly(
            "robot.xml:4: there is a second <registrar>, the first is in line 3;"
                + " a robot has one at most, so delete one");
  }

  @Test
  void twoLookups() {
    assertThat(folder().xml("<lookup/>", "<group name=\"a\"/>", "<lookup/>").complaints())
        .containsExactly(
            "robot.xml:4: there is a second <lookup>, the first is in line 2; make them one");
  }

  @Test
  void twoAdministrations() {
    String local = "<administration from=\"\"/>";
    assertThat(folder().xml(local, "<group name=\"a\"/>", local).complaints())
        .containsExactly(
            "robot.xml:4: there is a second <administration>, the first is in line 2;"
                + " make them one");
  }

  @Test
  void administratorsThatAreNeitherAddressNorRangeNorName() {
    String remedy =
        "\" is not understood; write an address, a range such as 10.0.0.0/24, or a host name";
    assertThat(
            folder()
                .xml(
                    "<administration from=\"10.0.0.256, base/24, 10.0.0.0/33, 10.0.0, fd00::/8,"
                        + " fd00::g, 10.0.0.0/, 10.0.0.0/8, base.local\"/>",
                    "<group name=\"a\"/>")
                .complaints())
        .containsExactly(
            "robot.xml:2: the administrator's address \"10.0.0.256" + remedy,
            "robot.xml:2: the administrator's address \"base/24" + remedy,
            "robot.xml:2: the administrator's address \"10.0.0.0/33" + remedy,
            "robot.xml:2: the administrator's address \"10.0.0" + remedy,
            "robot.xml:2: the administrator's address \"fd00::g" + remedy,
            "robot.xml:2: the administrator's address \"10.0.0.0/" + remedy);
  }

  @Test
  void moduleHostsThatAreNeitherAddressNorRangeNorName() {
    assertThat(
            folder()
                .xml(
                    """
                    <group name="a"><registrar module-hosts="10.0.0.256, 10.0.0.0/24, base"/></group>""")
                .complaints())
        .containsExactly(
            "robot.xml:2: the registrar's module host \"10.0.0.256\" is not understood; write an"
                + " address, a range such as 10.0.0.0/24, or a host name");
  }

  @Test
  void namesNotInLowerSnakeCase() {
    assertThat(
            folder()
                .document(
                    """
                    <robot xmlns="urn:dfra:robot:1" name="ATRV-1">
                      <group name="GpsFront">
                        <module name="42" properties="gps.properties"/>
                        <module name="gps" properties="gps.properties">
                          <parameter name="updateRate" value="1"/>
                        </module>
                      </group>
                    </robot>
                    """)
                .complaints())
        .containsExactly(
            "robot.xml:1: the robot name \"ATRV-1\" is not lower_snake_case; write \"atrv_1\"",
            "robot.xml:2: the group name \"GpsFront\" is not lower_snake_case; write \"gps_front\"",
            "robot.xml:3: the module name \"42\" is not lower_snake_case;"
                + " write lower-case letters, digits and single underscores, beginning with a"
                + " letter",
            "robot.xml:5: the parameter name \"updateRate\" is not lower_snake_case;"
                + " write \"update_rate\"");
  }

  @Test
  void badHost() {
    assertThat(
            folder()
                .document(
                    "<robot xmlns=\"urn:dfra:robot:1\" name=\"a\" host=\"\"><group name=\"b\"/></robot>")
                .complaints())
        .containsExactly("robot.xml:1: the host is \"\"; write one address or host name, or auto");
  }

  @Test
  void badPort() {
    for (String port : new String[] {"", "-1", "65536", "4160x", "99999999999"}) {
      assertThat(
              folder()
                  .xml("<group name=\"a\"><registrar port=\"" + port + "\"/></group>")
                  .complaints())
          .containsExactly(
              "robot.xml:2: the registrar's port is \""
                  + port
                  + "\"; write a whole number from 0 to 65535");
    }
  }

  @Test
  void badLocator() {
    for (String locator :
        new String[] {
          "base:0", "jini://base:70000", "http://base", "a b", "base/x", "u@base", "::1"
        }) {
      assertThat(
              folder()
                  .xml("<lookup locators=\"good," + locator + "\"/>", "<group name=\"a\"/>")
                  .complaints())
          .containsExactly(
              "robot.xml:2: the locator \""
                  + locator
                  + "\" is not understood; write host, host:port or jini://host:port,"
                  + " the port from 1 to 65535");
    }
  }

  @Test
  void emptyJvmOption() {
    assertThat(folder().xml("<group name=\"a\"><jvm-option> </jvm-option></group>").complaints())
        .containsExactly(
            "robot.xml:2: the JVM option is empty; write one, such as -Xmx64m, or delete it");
  }

  @Test
  void restartNeitherTrueNorFalse() {
    assertThat(
            folder()
                .xml(
                    "<group name=\"a\"><registrar restart=\"yes\"/>",
                    "<module name=\"m\" properties=\"gps.properties\" restart=\"\"/></group>")
                .complaints())
        .containsExactly(
            "robot.xml:2: restart is \"yes\"; write true or false",
            "robot.xml:3: restart is \"\"; write true or false");
  }

  @Test
  void duplicateParameter() {
    assertThat(
            folder()
                .module(
                    "<parameter name=\"link\" value=\"a\"/>",
                    "<parameter name=\"link\" value=\"a\"/>")
                .complaints())
        .containsExactly(
            "robot.xml:5: there is a second parameter link of module gps_front,"
                + " the first is in line 4; delete one");
  }

  @Test
  void missingProperties() {
    assertThat(
            folder()
                .xml(
                    "<group name=\"a\">",
                    "<module name=\"m\" properties=\"no.properties\"/></group>")
                .complaints())
        .containsExactly(
            "robot.xml:3: the properties file \"no.properties\" of module m does not exist;"
                + " name one, relative to robot.xml");
  }

  @Test
  void missingConfiguration() {
    assertThat(
            folder()
                .properties(RobotFolder.CLASSES + "configuration=no.config")
                .module()
                .complaints())
        .containsExactly(
            "gps.properties:4: the configuration file \"no.config\" of module gps_front does not"
                + " exist; name one, relative to gps.properties");
  }

  @Test
  void missingClasses() {
    assertThat(folder().properties("proxy=a.B").module().complaints())
        .containsExactly(
            "robot.xml:3: module gps_front has no server; write server=<class name> in"
                + " gps.properties",
            "robot.xml:3: module gps_front has no implementation; write implementation=<class name> in"
                + " gps.properties");
    assertThat(
            folder()
                .xml("<group name=\"a\"><module name=\"m\" server=\"S\" proxy=\"P\"/></group>")
                .complaints())
        .containsExactly(
            "robot.xml:2: module m has no implementation; write implementation=\"<class name>\" in it,"
                + " or name properties that hold it");
  }

  @Test
  void whatIsNoClassName() {
    assertThat(
            folder().properties(RobotFolder.CLASSES.replace(".M12", "/M12")).module().complaints())
        .containsExactly(
            "gps.properties:3: the implementation of module gps_front is"
                + " \"org.dfra.drivers.gps.m12/M12PlusImpl\", which is not a class name;"
                + " write the full name of a Java class");
  }

  @Test
  void unsetVariable() {
    assertThat(folder().module("<parameter name=\"link\" value=\"${DFRA_LINK}\"/>").complaints())
        .containsExactly(
            "robot.xml:4: the variable DFRA_LINK is not set; set it in the environment,"
                + " or write ${DFRA_LINK:-default}");
  }

  @Test
  void everythingWrongIsReportedAtOnceFileByFile() {
    assertThat(
            folder()
                .properties("sevrer=a.B\n" + RobotFolder.CLASSES + "parameter.link=${LINK}\n")
                .xml(
                    "<lookup locators=\"base:0\" team=\"x\"/>",
                    "<group name=\"a\"><registrar port=\"x\"/>",
                    "<module name=\"one\" properties=\"gps.properties\"/>",
                    "<module name=\"Two\" properties=\"gps.properties\" restart=\"maybe\"/>",
                    "</group>",
                    "<group name=\"a\"/>")
                .complaints())
        .satisfiesExactly(
            line -> assertThat(line).startsWith("robot.xml:2: the attribute team"),
            line -> assertThat(line).startsWith("robot.xml:2: the locator"),
            line -> assertThat(line).startsWith("robot.xml:3: the registrar's port"),
            line -> assertThat(line).startsWith("robot.xml:5: the module name"),
            line -> assertThat(line).startsWith("robot.xml:5: restart"),
            line -> assertThat(line).startsWith("robot.xml:7: there is a second group"),
            line -> assertThat(line).startsWith("gps.properties:1: \"sevrer\""),
            line -> assertThat(line).startsWith("gps.properties:5: the variable LINK"));
  }
}
