package org.dfra.core.config;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is said of a text that is no robot's XML. */
class RobotStructureFaultsTest {

  @TempDir Path temp;

  private RobotFolder folder() {
    return new RobotFolder(temp);
  }

  @Test
  void missingFile() {
    assertThat(folder().complaints())
        .containsExactly("robot.xml: there is no such file; name the XML file of a robot");
  }

  @Test
  void unreadableFile() {
    RobotFolder folder = folder();
    assertThat(folder.path("robot.xml").toFile().mkdir()).isTrue();

    assertThat(folder.complaints())
        .singleElement()
        .asString()
        .matches("robot.xml: the file cannot be read \\(.*\\); name a readable file");
  }

  @Test
  void notWellFormed() {
    assertThat(folder().xml("<group>").complaints())
        .containsExactly(
            "robot.xml:3: the XML is not well-formed (The element type \"group\" must be terminated"
                + " by the matching end-tag \"</group>\"); correct it here or just above");
    assertThat(folder().document("").complaints())
        .containsExactly(
            "robot.xml:1: the XML is not well-formed (Premature end of file);"
                + " correct it here or just above");
  }

  @Test
  void documentTypeAndWithItEveryExternalEntity() {
    assertThat(
            folder()
                .document(
                    """
                    <?xml version="1.0"?>
                    <!DOCTYPE robot [<!ENTITY x SYSTEM "file:///etc/hostname">]>
                    <robot xmlns="urn:dfra:robot:1" name="&x;"/>""")
                .complaints())
        .containsExactly(
            "robot.xml:2: a document type is not allowed, since it could name files elsewhere;"
                + " delete <!DOCTYPE …>");
  }

  @Test
  void wrongNamespaceOrRoot() {
    String remedy = "; write <robot xmlns=\"urn:dfra:robot:1\" …>";
    assertThat(folder().document("<robot name=\"a\"/>").complaints())
        .containsExactly("robot.xml:1: the root element is <robot> in no namespace" + remedy);
    assertThat(folder().document("\n<robot xmlns=\"urn:dfra:robot:2\"/>").complaints())
        .containsExactly(
            "robot.xml:2: the root element is <robot> in the namespace urn:dfra:robot:2" + remedy);
    assertThat(folder().document("<team xmlns=\"urn:dfra:robot:1\"/>").complaints())
        .containsExactly(
            "robot.xml:1: the root element is <team> in the namespace urn:dfra:robot:1" + remedy);
  }

  @Test
  void elementInAnotherNamespace() {
    assertThat(folder().xml("<group xmlns=\"\" name=\"a\"/>", "<group name=\"b\"/>").complaints())
        .containsExactly(
            "robot.xml:2: <group> is not in the namespace urn:dfra:robot:1 but is written as group;"
                + " delete its own xmlns");
  }

  @Test
  void unknownElement() {
    assertThat(folder().xml("<grup name=\"a\"/>").complaints())
        .containsExactly("robot.xml:2: <grup> is not known here; did you mean \"group\"?");
    assertThat(folder().xml("<behaviour/>", "<group name=\"a\"/>").complaints())
        .containsExactly(
            "robot.xml:2: <behaviour> is not known here; write <lookup> or <administration> or"
                + " <persona> or <group>");
  }

  @Test
  void unknownAttribute() {
    assertThat(folder().module("<parameter name=\"a\" valeu=\"b\" value=\"c\"/>").complaints())
        .containsExactly(
            "robot.xml:4: the attribute valeu is not known in <parameter>; did you mean \"value\"?");
    assertThat(folder().xml("<group name=\"a\" when=\"now\"/>").complaints())
        .containsExactly("robot.xml:2: the attribute when is not known in <group>; write name");
  }

  @Test
  void missingAttribute() {
    assertThat(folder().xml("<group/>").complaints())
        .containsExactly("robot.xml:2: <group> lacks its name; write name=\"…\" in it");
  }

  @Test
  void contentWhereNoneBelongs() {
    assertThat(
            folder()
                .xml(
                    "<lookup>field</lookup>",
                    "<group name=\"a\">gps</group>",
                    "<group name=\"b\">",
                    "<jvm-option unit=\"m\">-Xmx64</jvm-option>",
                    "<jvm-option>-Xmx64<parameter/></jvm-option></group>")
                .complaints())
        .containsExactly(
            "robot.xml:2: <lookup> must be empty; delete what is between its two tags",
            "robot.xml:3: <group> holds text beside its elements; delete it",
            "robot.xml:5: <jvm-option> takes no attribute; delete those it has",
            "robot.xml:6: <jvm-option> takes text only; delete the elements in it");
  }

  @Test
  void sentencesStayEnglishWhateverTheLanguageOfTheMachine() {
    Locale before = Locale.getDefault();
    Locale.setDefault(Locale.JAPAN);
    try {
      unknownElement();
      unknownAttribute();
      missingAttribute();
      notWellFormed();
    } finally {
      Locale.setDefault(before);
    }
  }

  @Test
  void aSecondPersonaAndAnEmptyGoal() {
    assertThat(
            folder()
                .xml("<persona/>", "<persona><goal> </goal></persona>", "<group name=\"g\"/>")
                .complaints())
        .containsExactly(
            "robot.xml:3: there is a second <persona>, the first is in line 2; make them one",
            "robot.xml:3: the goal is empty; write a sentence, or delete it");
  }
}
