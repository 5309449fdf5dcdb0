package org.dfra.module;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * A method that makes an emergency stop. Capacity of each server is kept for its calls, so that
 * other calls, however many, do not delay it. It returns soon, and its result is small.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.METHOD)
public @interface StopsRobot {}
