package org.dfra.activation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ObjectStreamClass;
import java.io.ObjectStreamField;
import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Serial versions and fields are those of Java SE 16, so that peers on older releases read them.
 */
class SerialFormTest {

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          ActivationID                           | -4608673054848209235 | ''
          ActivationGroupID                      | -1648432278909740833 | system ActivationSystem, uid UID
          ActivationDesc                         |  7455834104417690957 | className String, data MarshalledObject, groupID ActivationGroupID, location String, restart boolean
          ActivationGroupDesc                    | -4936225423168276595 | className String, data MarshalledObject, env CommandEnvironment, location String, props Properties
          ActivationGroupDesc$CommandEnvironment |  6165754737887770191 | command String, options String[]
          ActivationGroup                        | -7696947875314805420 | groupID ActivationGroupID, incarnation long, monitor ActivationMonitor
          Activatable                            | -3120617863591563455 | id ActivationID
          ActivationException                    | -4320118837291406071 | detail Throwable
          UnknownObjectException                 |  3425547551622251430 | ''
          UnknownGroupException                  |  7056094974750002460 | ''
          ActivateFailedException                |  4863550261346652506 | ''
          ActivationGroup_Stub                   |                    2 | ''
          """)
  void serialVersionAndFieldsAreThoseOfTheTable(String name, long version, String fields)
      throws ClassNotFoundException {
    ObjectStreamClass form = ObjectStreamClass.lookup(Class.forName("java.rmi.activation." + name));

    assertThat(form.getSerialVersionUID()).isEqualTo(version);
    assertThat(Arrays.stream(form.getFields()).map(SerialFormTest::described).sorted())
        .containsExactly(fields.isEmpty() ? new String[0] : fields.split(", "));
  }

  private static String described(ObjectStreamField field) {
    return field.getName() + " " + field.getType().getSimpleName();
  }
}
