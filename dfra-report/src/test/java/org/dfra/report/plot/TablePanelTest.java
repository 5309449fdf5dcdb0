package org.dfra.report.plot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;

class TablePanelTest {

  @Test
  void hasEveryCellAndKeepsWithinItsPanel() {
    TablePanel table =
        new TablePanel(
            List.of("Figure", "atrv1", "atrv2"),
            List.of(List.of("way", "12 m", "13 m"), List.of("time", "1 s", "a word ".repeat(99))));
    assertThat(new Page("").row(table.height(), table).svg())
        .contains(">Figure<", ">atrv2<", ">12 m<", ">time<", ">1 s<");
    assertThat(Bitmaps.inkAtEdge(Bitmaps.of(table, 400, table.height(), 10), 9)).isEmpty();
  }

  @Test
  void wantsACellForEachHeading() {
    assertThatThrownBy(() -> new TablePanel(List.of("a", "b"), List.of(List.of("1"))))
        .hasMessage("1 cells in a table of 2 columns");
  }
}
