package org.dfra.app.raster;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;

/** What is told on the way of a search by one robot. */
public final class ToldMarks implements MissionListener {

  private final List<MissionEvent> marks = new ArrayList<>();

  @Override
  public void onProgress(List<RobotProgress> robots) {
    assertThat(robots).hasSize(1);
  }

  @Override
  public void onEvent(MissionEvent mark) {
    marks.add(mark);
  }

  /** All that has happened, in the order in which it was told. */
  public List<MissionEvent> marks() {
    return List.copyOf(marks);
  }
}
